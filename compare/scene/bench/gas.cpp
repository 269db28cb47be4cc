// SPDX-License-Identifier: MIT
#include <compare/scene/bench/parts.h>
#include <compare/scene/bench/scenes.h>
#include <plumb/math/random.h>
#include <plumb/math/trig.h>
#include <cmath>
#include <numbers>

namespace plumb::compare {

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

}  // namespace plumb::compare
