// SPDX-License-Identifier: MIT
#include <compare/scene/bench/parts.h>
#include <compare/scene/bench/scenes.h>

namespace plumb::compare {

Scene small50() {
    Scene scene = benchScene("small_50", "What does a step of a small game take, a pyramid, a tower and balls?", 1000);
    scene.sleeping = false;
    scene.bodies.push_back(
        fixedBody("ground", {box({30, 1}), segment({-30, 1}, {-30, 20}), segment({30, 1}, {30, 20})}, {0, -1}));
    addPyramid(scene, 7, 0.5, {-10, 0.5});
    for (int i = 0; i < 10; ++i) addBody(scene, box({0.5, 0.5}), {6, 0.5 + i});
    for (int i = 0; i < 11; ++i)
        addBody(scene, circle(0.5, {.restitution = 0.5}), {10 + 1.25 * i, 3 + 0.5 * i}).def.velocity = {-2, 0};
    return scene;
}

}  // namespace plumb::compare
