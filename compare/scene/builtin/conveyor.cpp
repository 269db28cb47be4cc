// SPDX-License-Identifier: MIT
#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {

Scene conveyor() {
    const double speed = 2, friction = 0.3;  // of the belt [m/s], of both [-]
    const Vec2 halfSize(0.5, 0.25), start(-4, halfSize.y());
    const Material goods{.density = 1 / (4 * halfSize.prod()), .friction = friction};
    const Material belt{.friction = friction, .surfaceSpeed = speed};
    return {
        .name = "conveyor",
        .question = "How does a belt at 2 m/s take up a box that is put down on it?",
        .duration = 3,
        .bodies = {{"belt", {.type = BodyType::Static, .position = {0, -0.25}, .shapes = {box({5, 0.25}, belt)}}},
                   {"box", {.position = start, .shapes = {box(halfSize, goods)}}}},
        .closedForm = ClosedForm{.formula = "v = mu g t until the belt's speed, then that",
                                 .source = "textbook: Coulomb's law of friction",
                                 .bodies = {FreeMotion{"box"}}},
        .probes = {{.name = "normal",
                    .quantity = NormalForceProbe{"belt", "box"},
                    .expected = gravity,
                    .from = 0.5,
                    .unit = "N"}},
        .checks = {ExactCheck{1e-3, sinksOnGround +
                                        "5/8 of it under a box; friction drives a little less while the belt finds the "
                                        "load, and then for good"},
                   invariant("probe.normal", 0.01 * gravity, "1 %: the belt carries the weight")},
    };
}

}  // namespace plumb::compare
