// SPDX-License-Identifier: MIT
#include <compare/scene/bench/parts.h>
#include <compare/scene/bench/scenes.h>
#include <plumb/math/random.h>

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

}  // namespace plumb::compare
