// SPDX-License-Identifier: MIT
#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>
#include <plumb/math/random.h>

namespace plumb::compare {
namespace {

constexpr Material lively{.friction = 0, .restitution = 1};

/// At constant velocity in a world that wraps in x: parts of it, cut where it comes in at the other side.
void goAround(std::vector<Flight>& flights, double start, double time, double x, double speed, double width, double y) {
    const auto inside = [width](double at) { return at < 0 ? at + width : at >= width ? at - width : at; };
    const double seam = speed < 0 ? x / -speed : (width - x) / speed;
    flights.push_back({.start = start, .position = {inside(x), y}, .velocity = {speed, 0}});
    if (x >= 0 && x < width && seam < time)
        flights.push_back({.start = start + seam, .position = {speed < 0 ? width : 0.0, y}, .velocity = {speed, 0}});
}

}  // namespace

Scene wrapHeadOn() {
    // Two discs of 1 m on a ring of 8 m: 6 m are free between them, on one side or the other, so that they meet once a
    // second. The left one is between -0.47 and 2.53 m, the right one 4 m to 5 m on from it.
    const double width = 8, speed = 3, y = 0, first = 1.0 / 3;
    const double left = 0.53, right = 5.53;
    std::vector<Flight> a, b;
    goAround(a, 0, first, left, -speed, width, y);
    goAround(b, 0, first, right, speed, width, y);
    for (int meeting = 0; meeting < 10; ++meeting) {
        const bool atSeam = meeting % 2 == 0;
        const double start = first + meeting, sign = atSeam ? 1 : -1;
        const double fromA = atSeam ? left - 1 : left + 2, fromB = atSeam ? right + 1 : right - 2;
        // The left one starts beyond the seam, and comes in again.
        if (atSeam) {
            const double seam = -fromA / speed;
            a.push_back({.start = start, .position = {fromA + width, y}, .velocity = {speed, 0}});
            a.push_back({.start = start + seam, .position = {0, y}, .velocity = {speed, 0}});
        } else {
            goAround(a, start, 1, fromA, -speed, width, y);
        }
        goAround(b, start, 1, fromB, -sign * speed, width, y);
    }
    const auto disc = [](const char* name, double x, double v) -> SceneBody {
        return {name, {.position = {x, 0}, .velocity = {v, 0}, .shapes = {circle(0.5, lively)}}};
    };
    return {
        .name = "wrap_head_on",
        .question = "In a world of 8 m that goes on at its other side, do two discs meet across the seam?",
        .gravity = {0, 0},
        .duration = 10,
        .sleeping = false,
        .wrap = {.width = width},
        .bodies = {disc("left", left, -speed), disc("right", right, speed)},
        .closedForm = ClosedForm{.formula = "equal discs change velocities, once a second, on one side or the other",
                                 .source = "textbook: elastic impact of equal masses",
                                 .bodies = {PiecewiseMotion{"left", a}, PiecewiseMotion{"right", b}}},
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
                   invariant("momentum_drift", 1e-6, "nothing outside: what one gets another gives, in floats"),
                   invariant("penetration_max", 1e-3, "none may sink into another, or pass it at the seam")},
    };
    Random random(1);
    for (int i = 0; i < 20; ++i) {
        const Vec2 position(1.6 * (i % 5) + 0.2, 2.0 * (i / 5) + 0.1);
        const Vec2 velocity(random.uniform(-3, 3), random.uniform(-3, 3));
        scene.bodies.push_back({"disc_" + std::to_string(i + 1),
                                {.position = position, .velocity = velocity, .shapes = {circle(0.4, lively)}}});
    }
    return scene;
}

}  // namespace plumb::compare
