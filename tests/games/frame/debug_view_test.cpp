// SPDX-License-Identifier: MIT
#include <games/frame/debug_view.h>

#include <games/frame/canvas.h>
#include <plumb/plumb.h>
#include <plumb/shapes/tile_map.h>

#include "catch.h"

using namespace plumb;
using namespace plumb::games;

namespace {

constexpr DebugView shapesOnly{.boxes = false, .contacts = false, .joints = false, .velocities = false};

std::vector<Mark> marksOf(const World& world, const DebugView& view) {
    Canvas canvas({1280, 720});
    canvas.look({.center = {0, 0}, .height = 10});
    drawDebug(canvas, world, view);
    return canvas.drawing().marks;
}

/// The bounds of a mark without its line width, in the world of the camera above: 72 pixels per metre.
Aabb boundsOf(const Mark& mark) {
    std::vector<Vec2> points;
    if (const auto* path = std::get_if<PathMark>(&mark.shape)) points = path->points;
    if (const auto* rect = std::get_if<RectMark>(&mark.shape)) points = {rect->corner, rect->corner + rect->size};
    if (const auto* ellipse = std::get_if<EllipseMark>(&mark.shape))
        points = {ellipse->center - ellipse->radii, ellipse->center + ellipse->radii};
    std::optional<Aabb> box;
    for (const Vec2& point : points) {
        const Vec2 pixels = mark.toPixels * point;
        const Vec2 p((pixels.x() - 640) / 72, (360 - pixels.y()) / 72);
        box = box ? merge(*box, {p, p}) : Aabb{p, p};
    }
    return *box;
}

Aabb boundsOf(const std::vector<Mark>& marks) {
    Aabb all = boundsOf(marks.at(0));
    for (const Mark& mark : marks) all = merge(all, boundsOf(mark));
    return all;
}

TileMap aTile() {
    TileMap map({.columns = 3, .rows = 2, .size = 0.5});
    map.set({1, 1}, {TileForm::Full});
    return map;
}

}  // namespace

TEST_CASE("the drawn outlines of seven kinds of shapes have the same bounds as the shapes", "[games]") {
    const std::vector<ShapeDef> shapes{circle(0.5),
                                       capsule({-0.5, 0}, {0.5, 0}, 0.25),
                                       box({0.5, 0.3}),
                                       roundedBox({0.5, 0.3}, 0.2),
                                       segment({-1, 0}, {1, 0.5}),
                                       chain({{-1, 0}, {0, 1}, {1, 0}}),
                                       loop({{-1, 0}, {0, -1}, {1, 0}})};
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        CAPTURE(i);
        World world;
        const BodyId body = world.add({.type = BodyType::Static, .position = {1, 2}, .shapes = {shapes[i]}});
        const Aabb drawn = boundsOf(marksOf(world, shapesOnly)), is = aabbOf(shapes[i].shape, world.body(body).pose());
        // A rounded box is drawn by circles at its corners and edges, with the same bounds. Rounding of pixels: 1e-12.
        CHECK((drawn.lower - is.lower).norm() < 1e-9);
        CHECK((drawn.upper - is.upper).norm() < 1e-9);
    }
}

TEST_CASE("a turned shape is drawn turned, and a tile map is drawn by its tiles that are not empty", "[games]") {
    World world;
    world.add({.type = BodyType::Static, .position = {1, 2}, .shapes = {tiles(aTile())}});
    const auto tile = marksOf(world, shapesOnly);
    REQUIRE(tile.size() == 1);
    CHECK((boundsOf(tile).lower - Vec2(1.5, 2.5)).norm() < 1e-9);
    CHECK((boundsOf(tile).upper - Vec2(2, 3)).norm() < 1e-9);

    World turned;
    turned.add({.type = BodyType::Static, .angle = std::atan2(3, 4), .shapes = {segment({0, 0}, {1, 0})}});
    CHECK((boundsOf(marksOf(turned, shapesOnly)).upper - Vec2(0.8, 0.6)).norm() < 1e-9);
}

TEST_CASE("static, kinematic, awake and sleeping bodies and sensors have five different colours", "[games]") {
    World world({.gravity = {0, 0}});
    ShapeDef sensor = circle(0.2);
    sensor.sensor = true;
    world.add({.type = BodyType::Static, .position = {-4, 0}, .shapes = {segment({0, 0}, {1, 0})}});
    world.add({.type = BodyType::Kinematic, .position = {-2, 0}, .shapes = {segment({0, 0}, {1, 0})}});
    world.add({.position = {0, 0}, .shapes = {polygon({{0, 0}, {1, 0}, {0, 1}})}});
    world.add({.position = {2, 0}, .awake = false, .shapes = {polygon({{0, 0}, {1, 0}, {0, 1}})}});
    world.add({.type = BodyType::Static, .position = {4, 0}, .shapes = {sensor}});
    std::vector<Color> colors;
    for (const Mark& mark : marksOf(world, shapesOnly))
        if (colors.empty() || !(mark.brush.paint.color == colors.back())) colors.push_back(mark.brush.paint.color);
    CHECK(colors.size() == 5);
}

TEST_CASE("a crate at rest is drawn with its two contacts, each once, and their normals point away from the ground",
          "[games]") {
    World world;
    world.add({.type = BodyType::Static, .shapes = {box({4, 0.5})}});
    world.add({.position = {0, 1}, .shapes = {box({0.5, 0.5})}});
    for (int tick = 0; tick < 60; ++tick) world.step(1.0 / 60);
    const auto marks = marksOf(world, {.shapes = false, .boxes = false, .joints = false, .velocities = false});
    REQUIRE(marks.size() == 4);  // a point and a normal each
    for (std::size_t i = 1; i < 4; i += 2) {
        const auto& normal = std::get<PathMark>(marks[i].shape).points;
        CHECK(std::abs(normal[1].x() - normal[0].x()) < 1e-6);
        CHECK(normal[1].y() > normal[0].y() + 0.1);
        CHECK(std::abs(normal[0].y() - 0.5) < 0.01);  // contacts are soft
    }
}

TEST_CASE("boxes, velocities and joints are drawn at their places, and the figures are those of the world", "[games]") {
    World world({.gravity = {0, 0}});
    const BodyId a = world.add({.position = {-1, 0}, .velocity = {5, 0}, .shapes = {circle(0.5)}});
    const BodyId b = world.add({.position = {1, 0}, .shapes = {circle(0.5)}});
    world.join(DistanceJointDef{.bodyA = a, .bodyB = b, .anchorA = {-1, 0}, .anchorB = {1, 0}});
    const auto only = [&](bool DebugView::*part) {
        DebugView view{false, false, false, false, false};
        view.*part = true;
        return marksOf(world, view);
    };
    const Aabb box = boundsOf(only(&DebugView::boxes).at(0));
    CHECK((box.lower - Vec2(-1.5, -0.5)).norm() < 1e-9);
    const auto velocities = only(&DebugView::velocities);
    REQUIRE(velocities.size() == 1);
    CHECK((boundsOf(velocities).upper - Vec2(0, 0)).norm() < 1e-9);  // 5 m/s for a fifth of a second, from -1
    const Aabb link = boundsOf(only(&DebugView::joints).at(0));
    CHECK((link.lower - Vec2(-1, 0)).norm() < 1e-9);
    CHECK((link.upper - Vec2(1, 0)).norm() < 1e-9);
    // (pi / 4) (5 m/s)^2 / 2 at 1 kg/m^2
    CHECK(figuresOf(world) == FooterLine{"2 bodies, 2 awake", "2 shapes, 1 joints", "0 contacts, 0 touch",
                                         "kinetic 9.8 J", "gravitational 0.0 J"});
}

TEST_CASE("the debug view lies above everything that a game draws in a layer below debugLayer", "[games]") {
    World world;
    Canvas canvas({1280, 720});
    canvas.layer(debugLayer - 1);
    canvas.circle({0, 0}, 1, Color{});
    drawDebug(canvas, world);
    for (std::size_t i = 1; i < canvas.drawing().marks.size(); ++i)
        CHECK(canvas.drawing().marks[i].layer > canvas.drawing().marks[0].layer);
}
