// SPDX-License-Identifier: MIT
#include <plumb/impact/discs.h>

#include <cmath>
#include <iostream>
#include <limits>

#include <plumb/math/random.h>
#include <plumb/math/rot.h>

#include "cases.h"
#include "catch.h"

using namespace plumb;

namespace {

constexpr double discDigits = 0.5e-10;  // worked numbers stand to ten digits after the point

double inertiaOf(const Disc& disc) {
    return disc.inertiaRatio * disc.mass * disc.radius * disc.radius;
}

/// About the origin of the world [N m s].
double angularMomentum(const Disc& disc, const Vec2& velocity, double angularVelocity) {
    return disc.mass * cross(disc.position, velocity) + inertiaOf(disc) * angularVelocity;
}

double energy(const Disc& disc, const Vec2& velocity, double angularVelocity) {
    return disc.mass * velocity.squaredNorm() / 2 + inertiaOf(disc) * angularVelocity * angularVelocity / 2;
}

Disc randomDisc(Random& random) {
    return {.radius = std::exp(random.uniform(-1, 1)),
            .mass = std::exp(random.uniform(-2, 2)),
            .inertiaRatio = random.uniform(0.1, 1),
            .velocity = {random.uniform(-5, 5), random.uniform(-5, 5)},
            .angularVelocity = random.uniform(-5, 5)};
}

}  // namespace

// Worked numbers of response, 2D equal discs.
TEST_CASE("equal discs that meet 30 degrees off the line of centres part as the lecture says", "[impact][facts][law]") {
    const Disc a{.velocity = {1, 0}}, b{.position = {std::sqrt(3.0) / 2, 0.5}};
    const ImpactResult elastic = collideDiscs(a, b, {});
    CHECK((elastic.velocityA - Vec2(0.25, -0.4330127019)).norm() < 2 * discDigits);
    CHECK((elastic.velocityB - Vec2(0.75, 0.4330127019)).norm() < 2 * discDigits);
    const ImpactResult lossy = collideDiscs(a, b, {.restitution = 0.8});
    CHECK((lossy.velocityA - Vec2(0.325, -0.3897114317)).norm() < 2 * discDigits);
    CHECK((lossy.velocityB - Vec2(0.675, 0.3897114317)).norm() < 2 * discDigits);
}

// Worked numbers of response, disc on floor (Routh, Brach): r = 0.5, v = (4, -3), e = 0.5.
TEST_CASE("a disc that comes down at (4, -3) m/s rolls off at friction 0.5, slips at 0.2, and the threshold is 8/27",
          "[impact][facts][law]") {
    const Disc disc{.velocity = {4, -3}};
    const ImpactResult rolls = collideWithWall(disc, {}, {.restitution = 0.5, .friction = 0.5});
    CHECK(rolls.sticks);
    CHECK((rolls.velocityB - Vec2(8.0 / 3, 1.5)).norm() < 1e-14);
    CHECK(std::fabs(rolls.angularVelocityB + 5.3333333333) < discDigits);
    const ImpactResult slips = collideWithWall(disc, {}, {.restitution = 0.5, .friction = 0.2});
    CHECK_FALSE(slips.sticks);
    CHECK((slips.velocityB - Vec2(3.1, 1.5)).norm() < 1e-14);
    CHECK(std::fabs(slips.angularVelocityB + 3.6) < 1e-14);
    CHECK_FALSE(collideWithWall(disc, {}, {.restitution = 0.5, .friction = 8.0 / 27 - 1e-12}).sticks);
    CHECK(collideWithWall(disc, {}, {.restitution = 0.5, .friction = 8.0 / 27 + 1e-12}).sticks);
}

// Worked numbers of response, disc on floor: what ends the slip is k / (1 + k) of it.
TEST_CASE("what ends the slip is a third of it for a disc, 2/7 for a ball, a half for a ring", "[impact][facts][law]") {
    const auto part = [](double inertiaRatio) {
        const Disc disc{.mass = 3, .inertiaRatio = inertiaRatio, .velocity = {4, -3}, .angularVelocity = 2};
        const ImpactResult r = collideWithWall(disc, {}, {.restitution = 0.5, .friction = 10});
        return std::fabs(r.tangentImpulse) / (3 * (4 + 2 * 0.5));
    };
    CHECK(std::fabs(part(0.5) - 1.0 / 3) < 1e-15);
    CHECK(std::fabs(part(0.4) - 2.0 / 7) < 1e-15);
    CHECK(std::fabs(part(1) - 1.0 / 2) < 1e-15);
}

// Worked numbers of response, disc pair: tangential mass m / 6.
TEST_CASE("two alike discs that graze pass on slip by a sixth of their mass", "[impact][facts][law]") {
    const Disc a{.mass = 3, .velocity = {1, 2}}, b{.position = {1, 0}, .mass = 3, .velocity = {-1, 0}};
    const ImpactResult r = collideDiscs(a, b, {.friction = 1});
    CHECK(r.sticks);
    CHECK(std::fabs(r.tangentImpulse - 3 * 2 / 6.0) < 1e-15);
}

TEST_CASE("100,000 pairs of discs keep momentum, angular momentum about the world, and the law of restitution",
          "[impact][law]") {
    Random random(63);
    double momentum = 0, angular = 0, gain = 0, restitution = 0;
    int hits = 0;
    for (int i = 0; i < test::cases(100'000); ++i) {
        Disc a = randomDisc(random), b = randomDisc(random);
        const Rot turn = Rot::fromAngle(random.uniform(-3, 3));
        const Vec2 normal(turn.cos, turn.sin);
        a.position = {random.uniform(-5, 5), random.uniform(-5, 5)};
        b.position = a.position + (a.radius + b.radius) * normal;
        const double e = random.uniform(0, 1);
        const ImpactResult r = collideDiscs(a, b, {e, random.uniform(0, 1)});
        hits += r.normalImpulse > 0;
        const double size = (a.mass + b.mass) * 10;
        const Vec2 gained = a.mass * (r.velocityA - a.velocity) + b.mass * (r.velocityB - b.velocity);
        momentum = std::max(momentum, gained.norm() / size);
        const double turned =
            angularMomentum(a, r.velocityA, r.angularVelocityA) - angularMomentum(a, a.velocity, a.angularVelocity) +
            angularMomentum(b, r.velocityB, r.angularVelocityB) - angularMomentum(b, b.velocity, b.angularVelocity);
        angular = std::max(angular, std::fabs(turned) / (size * 10));
        const double before = energy(a, a.velocity, a.angularVelocity) + energy(b, b.velocity, b.angularVelocity);
        const double after = energy(a, r.velocityA, r.angularVelocityA) + energy(b, r.velocityB, r.angularVelocityB);
        gain = std::max(gain, after / before - 1);
        // A disc's turning moves its rim along, never to or from the other.
        const double closing = (a.velocity - b.velocity).dot(normal), parting = (r.velocityB - r.velocityA).dot(normal);
        restitution = std::max(restitution, std::fabs(parting - (closing > 0 ? e : -1) * closing) / 10);
    }
    std::cout << "impact: discs keep momentum to " << momentum << ", angular momentum to " << angular
              << ", restitution to " << restitution << ", and gain at most " << gain << " of their energy\n";
    // Some twenty roundings; masses and inertias differ by up to e^4 and more.
    CHECK(momentum < 20 * 1.1e-16);
    CHECK(angular < 20 * 1.1e-16 * 10);
    CHECK(gain < 20 * 1.1e-16 * 55);
    CHECK(restitution < 20 * 1.1e-16 * 55);
    CHECK(hits > test::cases(100'000) / 3);
}

TEST_CASE("a ball on a lift that comes up at 2 m/s leaves it at 2 + e (2 + v), and a belt drags it along",
          "[impact][law]") {
    const Disc ball{.velocity = {0, -3}};
    const ImpactResult lifted = collideWithWall(ball, {.velocity = {0, 2}}, {.restitution = 0.5});
    CHECK((lifted.velocityB - Vec2(0, 4.5)).norm() < 1e-15);
    const ImpactResult dragged = collideWithWall(ball, {.velocity = {1, 0}}, {.restitution = 0, .friction = 5});
    CHECK((dragged.velocityB - Vec2(1.0 / 3, 0)).norm() < 1e-15);  // as a disc that slips at 1 m/s
}

TEST_CASE("a disc of infinite mass is a round wall, and discs at one place have no normal", "[impact]") {
    const Disc post{.mass = std::numeric_limits<double>::infinity()};
    const Disc ball{.position = {0, 1}, .velocity = {0, -3}};
    CHECK(collideDiscs(post, ball, {}).velocityB == Vec2(0, 3));
    CHECK(collideDiscs(post, ball, {}).velocityA == Vec2(0, 0));
    const ImpactResult same = collideDiscs({.angularVelocity = 2}, {.velocity = {0, -3}}, {});
    CHECK(same.velocityB == Vec2(0, -3));
    CHECK(same.angularVelocityA == 2);
    CHECK(same.normalImpulse == 0);
}

TEST_CASE("discs that nothing is are refused by name", "[impact][errors]") {
    const Disc far{.position = {1, 0}};
    CHECK_THROWS_WITH(collideDiscs({.radius = 0}, far, {}), "Disc a.radius: 0 is not positive");
    CHECK_THROWS_WITH(collideDiscs(far, {.mass = -1}, {}), "Disc b.mass: -1 is not positive");
    CHECK_THROWS_WITH(collideDiscs({}, {.mass = -1}, {}), "Disc b.mass: -1 is not positive");  // at one place, too
    const double infinity = std::numeric_limits<double>::infinity();
    CHECK_THROWS_WITH(collideDiscs({.position = {0, infinity}}, far, {}), "Disc a.position: (0, inf) is not finite");
    CHECK_THROWS_WITH(collideDiscs(far, {.velocity = {0, infinity}}, {}), "Disc b.velocity: (0, inf) is not finite");
    CHECK_THROWS_WITH(collideWithWall({.velocity = {0, -infinity}}, {}, {.friction = 0.5}),
                      "Disc.velocity: (0, -inf) is not finite");
    CHECK_THROWS_WITH(collideWithWall({.angularVelocity = infinity}, {}, {}),
                      "Disc.angularVelocity: inf is not finite");
    CHECK_THROWS_WITH(collideWithWall({}, {.velocity = {0, infinity}}, {}),
                      "ImpactWall.velocity: (0, inf) is not finite");
    CHECK_THROWS_WITH(collideWithWall({.inertiaRatio = 0}, {}, {}), "Disc.inertiaRatio: 0 is not positive");
    CHECK_THROWS_WITH(collideWithWall({}, {.normal = {0, 2}}, {}), "impact: normal: (0, 2) is not a unit vector");
}
