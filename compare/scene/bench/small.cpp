// SPDX-License-Identifier: MIT
#include <compare/scene/bench/parts.h>
#include <compare/scene/bench/scenes.h>

namespace plumb::compare {
namespace {

/// The bodies in the scene besides the ground.
struct Small {
    int base;             // of the pyramid, in boxes
    int towers, stories;  // of boxes
    int balls;            // bouncing balls
};

Scene small(const std::string& name, const Small& counts) {
    constexpr int row = 11;  // balls side by side
    Scene scene = benchScene(name, "What does a step of a small game take, a pyramid, a tower and balls?", 1000);
    scene.sleeping = false;
    scene.bodies.push_back(
        fixedBody("ground", {box({30, 1}), segment({-30, 1}, {-30, 20}), segment({30, 1}, {30, 20})}, {0, -1}));
    addPyramid(scene, counts.base, 0.5, {-10, 0.5});
    for (int tower = 0; tower < counts.towers; ++tower)
        for (int i = 0; i < counts.stories; ++i)
            addBody(scene, box({0.5, 0.5}), {tower == 0 ? 6.0 : -10.0 - 4 * tower, 0.5 + i});
    for (int i = 0; i < counts.balls; ++i) {
        const Vec2 place(10 + 1.25 * (i % row), 3 + 0.5 * (i % row) + 1.5 * (i / row));
        addBody(scene, circle(0.5, {.restitution = 0.5}), place).def.velocity = {-2, 0};
    }
    return scene;
}

}  // namespace

Scene small20() {
    return small("small_20", {.base = 4, .towers = 1, .stories = 4, .balls = 5});
}

Scene small50() {
    return small("small_50", {.base = 7, .towers = 1, .stories = 10, .balls = 11});
}

Scene small200() {
    return small("small_200", {.base = 14, .towers = 4, .stories = 10, .balls = 54});
}

}  // namespace plumb::compare
