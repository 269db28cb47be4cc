// SPDX-License-Identifier: MIT
#include <numbers>

#include <compare/scene/bench/parts.h>
#include <compare/scene/bench/scenes.h>

namespace plumb::compare {

Scene tumblerOf2025() {
    constexpr int side = 45;         // boxes across and up
    constexpr double spacing = 0.4;  // [m]
    const Vec2 axis(0, 10);
    Scene scene = benchScene("tumbler", "What does a step of 2,025 tumbling boxes take?", 750);
    scene.bodies.push_back(fixedBody("ground", {}));
    const auto wall = [](const Vec2& halfSize, const Vec2& center) {
        return ShapeDef{boxPolygon(halfSize, center), Material{.density = 50}};
    };
    scene.bodies.push_back({"drum",
                            {.position = axis,
                             .shapes = {wall({0.5, 10}, {10, 0}), wall({0.5, 10}, {-10, 0}), wall({10, 0.5}, {0, 10}),
                                        wall({10, 0.5}, {0, -10})}}});
    const double speed = 25 * std::numbers::pi / 180;
    scene.joints.push_back(
        {"motor", "ground", "drum", RevoluteJointDef{.anchor = axis, .motorSpeed = speed, .maxMotorTorque = 1e8}});
    const ShapeDef small = box({0.125, 0.125});
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) addBody(scene, small, {-9 + column * spacing, 1 + row * spacing});
    return scene;
}

}  // namespace plumb::compare
