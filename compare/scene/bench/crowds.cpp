// SPDX-License-Identifier: MIT
#include <compare/scene/bench/scenes.h>

#include <cmath>
#include <numbers>

#include <compare/scene/bench/parts.h>
#include <plumb/math/random.h>
#include <plumb/math/trig.h>

namespace plumb::compare {

/// The heap is equally deep for a thousand bodies and for many. So the scene compares how the time of an engine grows,
/// not how a deeper heap moves.
Scene pile(int n) {
    constexpr int layers = 40;
    constexpr double spacing = 1.1, play = 0.04;  // [m]
    const int columns = n / layers;
    const double halfWidth = columns * spacing / 2 + 0.1;
    Scene scene = benchScene("pile_" + std::to_string(n), "How does the time of a step grow with a heap?", 120);
    scene.sleeping = false;
    const double height = 2 * layers;
    scene.bodies.push_back(fixedBody("bin", {ShapeDef{boxPolygon({halfWidth + 2, 1}, {0, -1})},
                                             ShapeDef{boxPolygon({1, height / 2}, {-halfWidth - 1, height / 2})},
                                             ShapeDef{boxPolygon({1, height / 2}, {halfWidth + 1, height / 2})}}));
    Random random(1);
    const ShapeDef kinds[] = {box({0.5, 0.5}), circle(0.5)};
    for (int i = 0; i < n; ++i) {
        const double x = (i % columns - (columns - 1) / 2.0) * spacing + random.uniform(-play, play);
        addBody(scene, kinds[random.integer(0, 1)], {x, 0.55 + (i / columns) * spacing});
    }
    return scene;
}

Scene pit(int n) {
    constexpr int columns = 28;
    constexpr double spacing = 0.6, play = 0.04, halfWidth = 9, radius = 0.25;  // [m]
    Scene scene = benchScene("pit_" + std::to_string(n), "What does a step take when a crowd falls into a pit?", 300);
    scene.sleeping = false;
    const double height = 20 + spacing * n / columns;
    const Material rough{.friction = 0.4};
    scene.bodies.push_back(fixedBody(
        "pit", {ShapeDef{.shape = boxPolygon({halfWidth + 2, 1}, {0, -1}), .material = rough},
                ShapeDef{.shape = boxPolygon({1, height / 2}, {-halfWidth - 1, height / 2}), .material = rough},
                ShapeDef{.shape = boxPolygon({1, height / 2}, {halfWidth + 1, height / 2}), .material = rough}}));
    Random random(1);
    const ShapeDef disc = circle(radius, {.friction = 0.4, .restitution = 0.3});
    const ShapeDef square = box({radius, radius}, rough);
    for (int i = 0; i < n; ++i) {
        const double x = (i % columns - (columns - 1) / 2.0) * spacing + random.uniform(-play, play);
        const double y = 1 + (i / columns) * spacing + random.uniform(-play, play);
        addBody(scene, i % 2 == 0 ? disc : square, {x, y});
    }
    return scene;
}

Scene gas(int n) {
    constexpr double radius = 0.1, filled = 0.4;  // [m, -]
    Scene scene = benchScene("gas_" + std::to_string(n), "What does a step take of a gas of elastic discs?", 300);
    scene.sleeping = false;
    scene.gravity = {0, 0};
    const double pi = std::numbers::pi, width = std::sqrt(n * pi * radius * radius / filled);
    scene.wrap = {.width = width, .height = width};
    const int columns = static_cast<int>(std::ceil(std::sqrt(n)));
    Random random(1);
    const ShapeDef disc = circle(radius, {.friction = 0, .restitution = 1});
    for (int i = 0; i < n; ++i) {
        const Vec2 place(i % columns + 0.5, i / columns + 0.5);
        const SinCos direction = sinCos(random.uniform(0, 2 * pi));
        addBody(scene, disc, place * (width / columns)).def.velocity = {direction.cos, direction.sin};
    }
    return scene;
}

Scene smash() {
    constexpr int columns = 120, rows = 80;
    constexpr double side = 0.4;  // of a small box; they touch [m]
    Scene scene = benchScene("smash", "What does a step take when 9,600 sleepers wake in a crash?", 300);
    scene.gravity = {0, 0};
    SceneBody& ram = addBody(scene, box({4, 4}, {.density = 8}), {-20, 0});
    ram.def.velocity = {40, 0};
    const ShapeDef small = box({side / 2, side / 2});
    for (int column = 0; column < columns; ++column)
        for (int row = 0; row < rows; ++row) {
            const Vec2 position(30 + column * side, (row - rows / 2) * side);
            addBody(scene, small, position).def.awake = false;
        }
    return scene;
}

}  // namespace plumb::compare
