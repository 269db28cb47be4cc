// SPDX-License-Identifier: MIT
#include <compare/scene/bench/parts.h>
#include <compare/scene/bench/scenes.h>

namespace plumb::compare {

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
