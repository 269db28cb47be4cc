// SPDX-License-Identifier: MIT
#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {

Scene smallTumbler() {
    const double inside = 2.75, half = 0.25;  // half of the drum's inside, half of its walls' thickness [m]
    const double middle = inside + half, length = inside + 2 * half;
    const auto wall = [](const Vec2& center, const Vec2& size) {
        return polygon(
            {center - size, center + Vec2(size.x(), -size.y()), center + size, center + Vec2(-size.x(), size.y())});
    };
    Scene scene{
        .name = "small_tumbler",
        .question = "Do boxes, discs and capsules stay in a drum that turns under them?",
        .duration = 20,
        .bodies = {{"drum",
                    {.type = BodyType::Kinematic,
                     .angularVelocity = 0.5,
                     .shapes = {wall({-middle, 0}, {half, length}), wall({middle, 0}, {half, length}),
                                wall({0, -middle}, {length, half}), wall({0, middle}, {length, half})}}}},
        .checks = {AgreeCheck{2 * std::numbers::sqrt2 * inside, 20,
                              "the hollow's diagonal: nobody is out, in either engine, or falls ever farther"},
                   // By chance: under 60 gravities near this one it is 45 mm in the middle, and 126 mm at the most.
                   invariant("penetration_max", 0.075,
                             "half of the least radius: twice as deep, one could come out behind another")},
    };
    const ShapeDef shapes[] = {box({0.2, 0.2}), circle(0.25), capsule({-0.15, 0}, {0.15, 0}, 0.15)};
    for (int i = 0; i < 36; ++i) {
        const Vec2 place(0.75 * (i % 6 - 2.5), 0.75 * (i / 6 - 2.5));
        scene.bodies.push_back(
            {"body_" + std::to_string(i + 1), {.position = place, .shapes = {shapes[(i + i / 6) % 3]}}});
    }
    return scene;
}

}  // namespace plumb::compare
