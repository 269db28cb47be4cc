// SPDX-License-Identifier: MIT
#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {
namespace {

/// A disc that spins clockwise is dropped from 1 m with e = 0.5. It lands at 0.4515 and 0.9031 s, and would land again
/// at 1.1289 s.
Scene slipLanding(double friction) {
    const double radius = 0.5;
    const Material material{.density = discDensity(1, radius), .friction = friction, .restitution = 0.5};
    return {
        .duration = 1.1,
        .bodies = {{"floor", {.type = BodyType::Static, .shapes = {segment({-10, 0}, {10, 0}, material)}}},
                   {"disc",
                    {.position = {-1, radius + 1}, .angularVelocity = -10, .shapes = {circle(radius, material)}}}},
        .closedForm = ClosedForm{.formula = "vn' = e vn; it sticks with vx + w r = 0 if mu (1 + e) vn >= s / 3, else "
                                            "vx and w r change by mu (1 + e) vn (1, 2)",
                                 .source = "textbook: Newton's law of impact, Coulomb's law of friction; Routh",
                                 .bodies = {FreeMotion{"disc"}}},
        .probes = {{.name = "angle", .quantity = AngleProbe{"disc"}, .unit = "rad"}},
        .checks = {ExactCheck{1e-6,
                              "each impact is solved at its own time in double: what is left is rounding and the "
                              "accuracy of that time, 1e-9 s at 5 m/s"},
                   invariant("probe.angle", 2e-6, "the limit of the way, over the radius")},
    };
}

}  // namespace

Scene slipLandingSticks() {
    Scene scene = slipLanding(0.8);
    scene.name = "slip_landing_sticks";
    scene.question = "Does a spinning disc that lands on a rough floor leave it rolling?";
    return scene;
}

Scene slipLandingSlips() {
    Scene scene = slipLanding(0.1);
    scene.name = "slip_landing_slips";
    scene.question = "How much of its spin does a disc lose that slips at both of its landings?";
    return scene;
}

}  // namespace plumb::compare
