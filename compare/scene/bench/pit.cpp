// SPDX-License-Identifier: MIT
#include <compare/scene/bench/parts.h>
#include <compare/scene/bench/scenes.h>
#include <plumb/math/random.h>

namespace plumb::compare {

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

}  // namespace plumb::compare
