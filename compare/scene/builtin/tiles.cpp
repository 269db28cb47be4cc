// SPDX-License-Identifier: MIT
#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>
#include <plumb/movers/move_and_slide.h>

namespace plumb::compare {
namespace {

constexpr double tile = 0.1;         // [m]
constexpr double halfHeight = 0.25;  // half of each body's height [m]
constexpr double apart = 3;          // from one body's ground to the next one's [m]
constexpr Material smoothBody{.friction = 0};

/// A body that slides on a ground of its own.
struct Slider {
    const char* name;
    ShapeDef shape;
};

std::vector<Slider> sliders() {
    return {{"box", box({halfHeight, halfHeight}, smoothBody)},
            {"disc", circle(halfHeight, smoothBody)},
            {"capsule", capsule({-halfHeight, 0}, {halfHeight, 0}, halfHeight, smoothBody)}};
}

ShapeDef row(int columns, int rows) {
    TileMap map({.columns = columns, .rows = rows, .size = tile});
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) map.set({x, y}, {.form = TileForm::Full});
    return tiles(map, smoothBody);
}

/// 1,000 tiles long; its top is at y = 0 of its own frame.
SceneBody floorOf(const std::string& name, double y) {
    return {name + "_floor", {.type = BodyType::Static, .position = {0, y - tile}, .shapes = {row(1000, 1)}}};
}
/// 500 tiles high, from y = 0 down.
SceneBody wallOf(const std::string& name, double x) {
    return {name + "_wall", {.type = BodyType::Static, .position = {x, -500 * tile}, .shapes = {row(1, 500)}}};
}

/// Watches the body along a line, and counts its snags.
void watch(Scene& scene, const std::string& body, const BodyMotion& motion, const Vec2& way) {
    scene.closedForm->bodies.push_back(motion);
    scene.probes.push_back({.name = "snags_" + body, .quantity = SnagsProbe{body, way}, .unit = "-"});
    scene.checks.push_back(invariant("probe.snags_" + body, 0, "inner edges are gone: nothing is there to catch on"));
}

/// An upright capsule, for which Box2D 3 has a character mover. It always tries to move along its ground and into it.
void addMover(Scene& scene, const Vec2& start, const Vec2& along, const Vec2& out) {
    const double pace = 10, press = 2;  // along its ground, and onto it [m/s]
    const ShapeDef upright = capsule({0, -halfHeight}, {0, halfHeight}, halfHeight, smoothBody);
    const double skin = SlideSettings{}.skin, below = out.y() > 0 ? 2 * halfHeight : halfHeight;
    const Vec2 place = start + (below + skin) * out, velocity = pace * along;
    scene.bodies.push_back(
        {"mover", {.type = BodyType::Kinematic, .position = place, .velocity = velocity, .shapes = {upright}}});
    scene.movers.push_back(
        {.name = "player", .body = "mover", .motion = SlidingMotion{velocity - press * out, 0, StandIn::Stopped}});
    watch(scene, "mover", PiecewiseMotion{"mover", {{.position = place, .velocity = velocity}}}, along);
}

}  // namespace

Scene tileFloor() {
    const double speed = 10;
    Scene scene{
        .name = "tile_floor",
        .question = "Do a box, a disc, a capsule or a mover catch where 1,000 flush tiles of a floor meet?",
        .duration = 9.5,
        .closedForm = ClosedForm{.formula = "x = x0 + v t", .source = "Newton's first law: the floor is smooth"},
        .checks = {ExactCheck{1e-4, sinksOnGround + "5/8 of it under two corners; and nothing along the floor"}},
    };
    double floor = 0;
    for (const Slider& slider : sliders()) {
        const Vec2 start(1, floor + halfHeight);
        scene.bodies.push_back(floorOf(slider.name, floor));
        scene.bodies.push_back({slider.name, {.position = start, .velocity = {speed, 0}, .shapes = {slider.shape}}});
        watch(scene, slider.name, FreeMotion{slider.name}, {1, 0});
        floor -= apart;
    }
    scene.bodies.push_back(floorOf("mover", floor));
    addMover(scene, {1, floor}, {1, 0}, {0, 1});
    return scene;
}

Scene tileWall() {
    const double press = 5;  // [m/s^2]
    Scene scene{
        .name = "tile_wall",
        .question =
            "Do a box, a disc, a capsule or a mover catch on their way down a wall of flush tiles, pressed to it?",
        .gravity = {press, -gravity},
        .duration = 3,
        .closedForm = ClosedForm{.formula = "y = y0 - g t^2 / 2", .source = "free fall: the wall is smooth"},
        .checks = {ExactCheck{4e-4,
                              "the solver adds up a speed of up to 29 m/s in floats, 720 times, each rounded by up to "
                              "1 µm/s: at most 1 mm; across the wall a contact gives way by 0.035 mm"}},
    };
    double wall = 0;
    for (const Slider& slider : sliders()) {
        const bool lies = std::holds_alternative<Capsule>(slider.shape.shape);
        const Vec2 start(wall - halfHeight, -1);
        const double angle = lies ? degrees(90) : 0;
        scene.bodies.push_back(wallOf(slider.name, wall));
        scene.bodies.push_back({slider.name, {.position = start, .angle = angle, .shapes = {slider.shape}}});
        watch(scene, slider.name, FreeMotion{slider.name}, {0, -1});
        wall += apart;
    }
    scene.bodies.push_back(wallOf("mover", wall));
    addMover(scene, {wall, -1}, {0, -1}, {-1, 0});
    return scene;
}

}  // namespace plumb::compare
