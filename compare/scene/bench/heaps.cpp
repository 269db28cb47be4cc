// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include <compare/scene/bench/parts.h>
#include <compare/scene/bench/scenes.h>
#include <plumb/math/rot.h>
#include <plumb/math/trig.h>

namespace plumb::compare {
namespace {

/// A floor of blocks 1 m wide from -halfWidth to halfWidth, and a wall of blocks over each of its ends.
std::vector<ShapeDef> blocks(int halfWidth, int wallHeight) {
    std::vector<ShapeDef> shapes;
    for (int x = -halfWidth; x <= halfWidth; ++x) shapes.push_back({boxPolygon({0.55, 0.5}, {x, 0})});
    for (const int x : {-halfWidth, halfWidth})
        for (int y = 1; y <= wallHeight; ++y) shapes.push_back({boxPolygon({0.5, 0.55}, {x, y})});
    return shapes;
}

/// Five points on a circle, each turned from the last by the golden angle.
ShapeDef pentagon(double radius) {
    std::vector<Vec2> points;
    for (int i = 0; i < 5; ++i) {
        const SinCos turned = sinCos(std::numbers::pi * (std::sqrt(5.0) - 1) * i);
        points.push_back(radius * Vec2(turned.cos, turned.sin));
    }
    return {hullOf(points)};
}

/// The shift of a body's shapes, which changes sides from each place to the next.
class Sides {
public:
    explicit Sides(double first) : next_(first) {}
    double next() {
        next_ = -next_;
        return -next_;
    }

private:
    double next_;
};

}  // namespace

Scene junkyard() {
    constexpr int columns = 200, rows = 40;
    constexpr double radius = 0.25;
    Scene scene = benchScene("junkyard", "What does a step take when 8,000 pentagons are pushed about?", 800);
    scene.bodies.push_back(fixedBody("ground", blocks(80, 50)));
    const ShapeDef piece = pentagon(radius);
    Sides sides(-0.1);
    for (int column = 0; column < columns; ++column)
        for (int row = 0; row < rows; ++row)
            addBody(scene, piece, {1.5 * (2 * column - columns) * radius + sides.next(), 4 * row * radius + 15});
    scene.bodies.push_back({"pusher", {.type = BodyType::Kinematic, .shapes = {ShapeDef{boxPolygon({2, 4}, {0, 4})}}}});
    scene.movers.push_back({"sway", "pusher", SwingMotion{.amplitude = {60, 0}, .rate = 0.2}});
    return scene;
}

Scene compounds() {
    constexpr int columns = 20, rows = 150;
    Scene scene = benchScene("compounds", "What does a step of 3,000 bodies of two triangles each take?", 500);
    std::vector<ShapeDef> ground = blocks(40, 100);
    ground.push_back(segment({-800, -80}, {800, -80}));
    scene.bodies.push_back(fixedBody("ground", ground));
    const Material rough{.friction = 0.5};
    const std::vector<Vec2> left{{-1, 0}, {0.5, 1}, {0, 2}}, right{{1, 0}, {-0.5, 1}, {0, 2}};
    const std::vector<ShapeDef> pair{{hullOf(left), rough}, {hullOf(right), rough}};
    Sides sides(0.25);
    for (int column = 0; column < columns; ++column)
        for (int row = 0; row < rows; ++row)
            addBody(scene, pair.front(), {2 * column - 19 + sides.next(), 2.25 * row + 5.575}).def.shapes = pair;
    return scene;
}

Scene washer() {
    constexpr int side = 90, wedges = 36;
    constexpr double half = 0.1, wedge = std::numbers::pi / 18, play = wedge / 10;
    constexpr double inside = 14, inner = 16,
                     outer = 18;  // a paddle reaches in to inside; the drum is between the other two [m]
    Scene scene = benchScene("washer", "What does a step of 8,100 boxes in a turning drum take?", 500);
    SceneBody drum{"drum",
                   {.type = BodyType::Kinematic,
                    .position = {0, 10},
                    .velocity = {0.001, -0.002},
                    .angularVelocity = 25 * std::numbers::pi / 180}};
    const auto piece = [](double near, double far, double from, double to) {
        const Rot first = Rot::fromAngle(from), second = Rot::fromAngle(to);
        const Vec2 corners[] = {first * Vec2(near, 0), first * Vec2(far, 0), second * Vec2(near, 0),
                                second * Vec2(far, 0)};
        return ShapeDef{hullOf(corners)};
    };
    for (int i = 0; i < wedges; ++i) {
        drum.def.shapes.push_back(piece(inner, outer, i * wedge - play, (i + 1) * wedge + play));
        if (i % 9 == 0) drum.def.shapes.push_back(piece(inside, inner, i * wedge, (i + 1) * wedge));
    }
    scene.bodies.push_back(drum);
    const ShapeDef small = box({half, half});
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            addBody(scene, small, Vec2(-1.1 * half * side, 10 - 1.1 * half * side) + 2.1 * half * Vec2(column, row));
    return scene;
}

}  // namespace plumb::compare
