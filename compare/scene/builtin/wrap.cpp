// SPDX-License-Identifier: MIT
#include <cmath>

#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>
#include <plumb/math/random.h>

namespace plumb::compare {
namespace {

constexpr Material lively{.friction = 0, .restitution = 1};

}  // namespace

Scene wrapHeadOn() {
    // Two discs of 1 m on a ring of 8 m, so 6 m are free between them. Each moves at 3 m/s relative to an observer who
    // moves along at 0.3713 m/s, so they meet once a second, and all around the ring.
    const double ring = 8, speed = 3, drift = 0.3713;
    const double left = 1.3, right = 6.3;
    const auto disc = [](const char* name, double x, double v) -> SceneBody {
        return {name, {.position = {x, 0}, .velocity = {v, 0}, .shapes = {circle(0.5, lively)}}};
    };
    return {
        .name = "wrap_head_on",
        .question = "In a world of 8 m that goes on at its other side, do two discs meet across the seam?",
        .gravity = {0, 0},
        .duration = 10,
        .sleeping = false,
        .wrap = {.width = ring},
        .bodies = {disc("left", left, drift - speed), disc("right", right, drift + speed)},
        .closedForm = ClosedForm{.formula = "equal discs change velocities, once a second, on one side or the other",
                                 .source = "textbook: elastic impact of equal masses",
                                 .bodies = {FreeMotion{"left"}, FreeMotion{"right"}}},
        .checks = {ExactCheck{1e-9, "impacts are solved when they happen, in double, across the seam as elsewhere"},
                   invariant("energy_drift", 1e-12, "elastic"), invariant("momentum_drift", 1e-12, "nothing outside")},
    };
}

Scene wrapBilliard() {
    const double width = 8;
    Scene scene{
        .name = "wrap_billiard",
        .question = "Do twenty elastic discs keep energy and momentum in a world without edges?",
        .gravity = {0, 0},
        .duration = 20,
        .sleeping = false,
        .wrap = {.width = width, .height = width},
        .checks = {invariant("energy_drift", 1e-3,
                             "each impact by itself is exact; those of three at once go to the solver, and are few"),
                   invariant("momentum_drift", 1e-6, "no force from outside: one gains what another loses, in floats"),
                   invariant("penetration_max", 1e-3, "none may sink into another, or pass it at the seam")},
    };
    Random random(1);
    for (int i = 0; i < 20; ++i) {
        const Vec2 position(1.6 * (i % 5) + 0.2, 2.0 * (i / 5) + 0.1);
        // One after the other, because the compiler may choose the order in which it evaluates arguments.
        const double vx = random.uniform(-3, 3);
        const double vy = random.uniform(-3, 3);
        scene.bodies.push_back({"disc_" + std::to_string(i + 1),
                                {.position = position, .velocity = {vx, vy}, .shapes = {circle(0.4, lively)}}});
    }
    return scene;
}

}  // namespace plumb::compare
