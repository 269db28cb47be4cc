// SPDX-License-Identifier: MIT
#include <numbers>

#include <compare/scene/bench/parts.h>
#include <compare/scene/bench/scenes.h>
#include <compare/scene/builtin/doll.h>
#include <compare/scene/builtin/links.h>
#include <compare/scene/builtin/scenes.h>
#include <plumb/math/random.h>
#include <plumb/math/rot.h>

namespace plumb::compare {
namespace {

constexpr double toes = 1.4, reach = 0.92;  // from the neck to the toes; from a doll's middle to its farthest point [m]
const Vec2 middle(0, -0.52);                // from the neck of a standing doll to its middle [m]
const Material rough{.friction = 0.4};

std::string dollName(int number) {
    return "doll_" + std::to_string(number) + "_";
}

}  // namespace

Scene dolls100() {
    constexpr int side = 10;
    constexpr double apart = 2, halfWidth = 11, height = 20;  // [m]
    Scene scene = benchScene("dolls_100", "What does a step of a heap of 100 dolls of nine joints take?", 600);
    scene.sleeping = false;
    scene.bodies.push_back(fixedBody("pit", {ShapeDef{boxPolygon({halfWidth + 2, 1}, {0, -1}), rough},
                                             ShapeDef{boxPolygon({1, height}, {-halfWidth - 1, height}), rough},
                                             ShapeDef{boxPolygon({1, height}, {halfWidth + 1, height}), rough}}));
    Random random(1);
    for (int i = 0; i < side * side; ++i) {
        const double angle = random.uniform(-std::numbers::pi, std::numbers::pi);
        const Vec2 place(apart * (i % side - (side - 1) / 2.0), 1 + reach + apart * (i / side));
        const Vec2 neck = place - Rot::fromAngle(angle) * middle;
        addDoll(scene, {.name = dollName(i + 1), .neck = neck, .angle = angle, .group = i + 1});
    }
    return scene;
}

Scene dolls(int n) {
    constexpr double apart = 3, fall = 2.5;  // [m]
    Scene scene = benchScene("dolls_" + std::to_string(n), "What does a step of some dolls on the ground take?", 600);
    scene.sleeping = false;
    scene.bodies.push_back(fixedBody("ground", {box({apart * n, 1}, rough)}, {0, -1}));
    for (int i = 0; i < n; ++i)
        addDoll(scene, {.name = dollName(i + 1), .neck = {apart * (i - (n - 1) / 2.0), fall + toes}, .group = i + 1});
    return scene;
}

Scene rope60() {
    Scene scene = ropeHeapsUp();
    scene.name = "rope_60";
    scene.question = "What does a step take when a rope of 60 links falls in a heap?";
    scene.gravity = {0, -10};
    scene.duration = 400 * scene.dt;
    scene.checks.clear();
    scene.sleeping = false;
    return scene;
}

Scene bridge20() {
    Scene scene = bridgeUnderLoad();
    scene.name = "bridge_20";
    scene.question = "What does a step of a bridge of twenty planks under three boxes take?";
    scene.checks.clear();
    scene.sleeping = false;
    return scene;
}

}  // namespace plumb::compare
