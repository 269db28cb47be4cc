// SPDX-License-Identifier: MIT
#include <plumb/impact/impact.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <plumb/math/random.h>
#include <plumb/math/rot.h>

#include "catch.h"
#include "numbers.h"

using namespace plumb;
using namespace plumb::test;

namespace {

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

bool near(double a, double b, double tolerance) {
    return std::fabs(a - b) <= tolerance;
}
bool near(const Vec2& a, const Vec2& b, double tolerance) {
    return near(a.x(), b.x(), tolerance) && near(a.y(), b.y(), tolerance);
}

// Worked numbers stand to ten digits after the point.
constexpr double impactDigits = 0.5e-10;

const ImpactSide floorSide{};

// A disc of 1 kg and 0.5 m on the floor below it: I = m r^2 / 2.
ImpactSide discOnFloor(const Vec2& velocity, double angularVelocity = 0) {
    return {.velocity = velocity,
            .angularVelocity = angularVelocity,
            .inverseMass = 1,
            .inverseInertia = 8,
            .arm = {0, -0.5}};
}

Vec2 pointVelocity(const Vec2& velocity, double angularVelocity, const Vec2& arm) {
    return {velocity.x() - angularVelocity * arm.y(), velocity.y() + angularVelocity * arm.x()};
}

double kinetic(const ImpactSide& s, const Vec2& velocity, double angularVelocity) {
    return (s.inverseMass > 0 ? velocity.squaredNorm() / s.inverseMass / 2 : 0) +
           (s.inverseInertia > 0 ? angularVelocity * angularVelocity / s.inverseInertia / 2 : 0);
}

ImpactSide someSide(Random& random) {
    const double mass = std::exp(random.uniform(-3, 3));
    const double gyration = std::exp(random.uniform(-2, 1));
    return {.velocity = {random.uniform(-5, 5), random.uniform(-5, 5)},
            .angularVelocity = random.uniform(-10, 10),
            .inverseMass = 1 / mass,
            .inverseInertia = 1 / (mass * gyration * gyration),
            .arm = {random.uniform(-2, 2), random.uniform(-2, 2)}};
}

/// What an impact left, against what the laws say; each relative to the sizes that went into it.
struct Audit {
    double momentum = 0, angularMomentum = 0, energyGain = 0, restitution = 0, friction = 0, slip = 0;
    int sticks = 0, slides = 0, limited = 0, apart = 0;

    void hold(const ImpactSide& a, const ImpactSide& b, const Vec2& normal, const ImpactLaw& law);
};

void Audit::hold(const ImpactSide& a, const ImpactSide& b, const Vec2& normal, const ImpactLaw& law) {
    const ImpactResult r = impact(a, b, normal, law);
    const Vec2 tangent(-normal.y(), normal.x());
    const double speed = a.velocity.norm() + b.velocity.norm() + std::fabs(a.angularVelocity) * a.arm.norm() +
                         std::fabs(b.angularVelocity) * b.arm.norm();
    const Vec2 before =
        pointVelocity(b.velocity, b.angularVelocity, b.arm) - pointVelocity(a.velocity, a.angularVelocity, a.arm);
    const Vec2 after =
        pointVelocity(r.velocityB, r.angularVelocityB, b.arm) - pointVelocity(r.velocityA, r.angularVelocityA, a.arm);
    if (before.dot(normal) >= 0) {
        ++apart;
        CHECK((r.velocityA == a.velocity && r.angularVelocityB == b.angularVelocity && r.normalImpulse == 0));
        return;
    }
    // With the point of contact as origin the centres lie at -arm.
    const double mA = 1 / a.inverseMass, mB = 1 / b.inverseMass;
    const Vec2 changeA = mA * (r.velocityA - a.velocity), changeB = mB * (r.velocityB - b.velocity);
    const double spinA = (r.angularVelocityA - a.angularVelocity) / a.inverseInertia + cross(-a.arm, changeA);
    const double spinB = (r.angularVelocityB - b.angularVelocity) / b.inverseInertia + cross(-b.arm, changeB);
    const double size = (mA + mB) * speed;
    momentum = std::max(momentum, (changeA + changeB).norm() / size);
    angularMomentum = std::max(
        angularMomentum, (std::fabs(spinA) + std::fabs(spinB)) /
                             (size * (a.arm.norm() + b.arm.norm()) + std::fabs(a.angularVelocity) / a.inverseInertia +
                              std::fabs(b.angularVelocity) / b.inverseInertia));
    const double energy = kinetic(a, a.velocity, a.angularVelocity) + kinetic(b, b.velocity, b.angularVelocity);
    const double rest = kinetic(a, r.velocityA, r.angularVelocityA) + kinetic(b, r.velocityB, r.angularVelocityB);
    energyGain = std::max(energyGain, (rest - energy) / energy);
    restitution = std::max(restitution, std::fabs(after.dot(normal) + law.restitution * before.dot(normal)) / speed);
    const double cone = std::fabs(r.tangentImpulse) - law.friction * r.normalImpulse;
    friction = std::max(friction, cone / (size * std::max(1.0, law.friction)));
    if (r.sticks) {
        ++sticks;
        slip = std::max(slip, std::fabs(after.dot(tangent)) / speed);
    } else if (cone > -1e-9 * size) {
        ++slides;
        // What slips on does so against the friction.
        slip = std::max(slip, after.dot(tangent) * r.tangentImpulse / (speed * size));
    } else {
        ++limited;
    }
    CHECK(r.normalImpulse >= 0);
}

}  // namespace

TEST_CASE("2 kg at 3 m/s and 1 kg at -1 m/s part at 1/3 and 13/3 m/s, or at e = 0.5 at 1 and 3",
          "[impact][facts][law]") {
    const ImpactSide a{.velocity = {3, 0}, .inverseMass = 0.5};
    const ImpactSide b{.velocity = {-1, 0}, .inverseMass = 1};
    const ImpactResult elastic = impact(a, b, {1, 0}, {.restitution = 1});
    CHECK(near(elastic.velocityA, {1.0 / 3, 0}, 1e-15));
    CHECK(near(elastic.velocityB, {13.0 / 3, 0}, 1e-15));
    CHECK(near(elastic.normalImpulse, 16.0 / 3, 1e-15));
    const ImpactResult half = impact(a, b, {1, 0}, {.restitution = 0.5});
    CHECK(near(half.velocityA, {1, 0}, 1e-15));
    CHECK(near(half.velocityB, {3, 0}, 1e-15));
    const ImpactResult none = impact(a, b, {1, 0}, {.restitution = 0});
    CHECK(near(none.velocityA, {5.0 / 3, 0}, 1e-15));
    CHECK(near(none.velocityB, {5.0 / 3, 0}, 1e-15));
}

TEST_CASE("equal discs that meet 30 degrees off the line part as the lecture says", "[impact][facts][law]") {
    const ImpactSide a{.velocity = {1, 0}, .inverseMass = 1};
    const ImpactSide b{.inverseMass = 1};
    const Vec2 normal(std::sqrt(3.0) / 2, 0.5);
    const ImpactResult elastic = impact(a, b, normal, {.restitution = 1});
    CHECK(near(elastic.velocityA, {0.25, -0.4330127019}, impactDigits));
    CHECK(near(elastic.velocityB, {0.75, 0.4330127019}, impactDigits));
    const ImpactResult lossy = impact(a, b, normal, {.restitution = 0.8});
    CHECK(near(lossy.velocityA, {0.325, -0.3897114317}, impactDigits));
    CHECK(near(lossy.velocityB, {0.675, 0.3897114317}, impactDigits));
}

TEST_CASE("a disc thrown at the floor rolls off at friction 0.5, and slips at 0.2", "[impact][facts][law]") {
    const ImpactResult rolls = impact(floorSide, discOnFloor({4, -3}), {0, 1}, {.restitution = 0.5, .friction = 0.5});
    CHECK(rolls.sticks);
    CHECK(near(rolls.velocityB, {8.0 / 3, 1.5}, impactDigits));
    CHECK(near(rolls.angularVelocityB, -5.3333333333, impactDigits));
    CHECK(rolls.velocityA == Vec2(0, 0));
    const ImpactResult slips = impact(floorSide, discOnFloor({4, -3}), {0, 1}, {.restitution = 0.5, .friction = 0.2});
    CHECK_FALSE(slips.sticks);
    CHECK(near(slips.velocityB, {3.1, 1.5}, impactDigits));
    CHECK(near(slips.angularVelocityB, -3.6, impactDigits));
}

TEST_CASE("the friction at which the thrown disc ceases to slip is 8/27", "[impact][facts][law]") {
    const auto sticks = [](double friction) {
        return impact(floorSide, discOnFloor({4, -3}), {0, 1}, {.restitution = 0.5, .friction = friction}).sticks;
    };
    CHECK_FALSE(sticks(8.0 / 27 - 1e-12));
    CHECK(sticks(8.0 / 27 + 1e-12));
}

TEST_CASE("two equal discs that graze stick by a tangential mass of a sixth of one", "[impact][facts][law]") {
    // Discs of 3 kg and 0.5 m, side by side; slip 2 m/s.
    const double inverseInertia = 1 / (0.5 * 3 * 0.25);
    const ImpactSide a{.velocity = {1, 2}, .inverseMass = 1.0 / 3, .inverseInertia = inverseInertia, .arm = {0.5, 0}};
    const ImpactSide b{.velocity = {-1, 0}, .inverseMass = 1.0 / 3, .inverseInertia = inverseInertia, .arm = {-0.5, 0}};
    const ImpactResult r = impact(a, b, {1, 0}, {.restitution = 1, .friction = 1});
    CHECK(r.sticks);
    CHECK(near(r.tangentImpulse, 3 * 2 / 6.0, 1e-15));
    CHECK(near(r.normalImpulse, 6, 1e-14));
}

TEST_CASE("a ball that strikes the end of a free rod of its mass keeps 0.6 of its speed", "[impact][law]") {
    // At its end a rod of mass m and length L has the effective mass m / 4: 1/m + (L/2)^2 / (m L^2 / 12) = 4 / m.
    const ImpactSide ball{.velocity = {0, 5}, .inverseMass = 1};
    const ImpactSide rod{.inverseMass = 1, .inverseInertia = 12.0 / 4, .arm = {1, 0}};
    const ImpactResult r = impact(ball, rod, {0, 1}, {.restitution = 1});
    CHECK(near(r.velocityA, {0, 3}, 1e-14));
    CHECK(near(r.velocityB, {0, 2}, 1e-14));
    CHECK(near(r.angularVelocityB, 2.4 * 5 / 2, 1e-14));
}

TEST_CASE("100,000 random impacts obey momentum, restitution and friction, and gain no energy", "[impact][law]") {
    Random random(47);
    Audit audit;
    for (int i = 0; i < 100'000; ++i) {
        const double restitution = random.integer(0, 3) == 0 ? random.integer(0, 1) : random.uniform(0, 1);
        const double friction = random.integer(0, 4) == 0 ? 0 : std::exp(random.uniform(-4, 3));
        const Rot turn = Rot::fromAngle(random.uniform(-3, 3));
        audit.hold(someSide(random), someSide(random), {turn.cos, turn.sin}, {restitution, friction});
    }
    // Impulses are solved to some ten roundings of 1.1e-16; masses that differ by e^6 = 400, and arms of up to 15 times
    // the radius of gyration (15^2 = 225 in K, which the division for m squares at worst), amplify them.
    CHECK(audit.momentum < 10 * 1.1e-16 * 400);
    CHECK(audit.angularMomentum < 10 * 1.1e-16 * 400);
    CHECK(audit.energyGain < 10 * 1.1e-16 * 400);
    CHECK(audit.restitution < 10 * 1.1e-16 * 225 * 10);
    CHECK(audit.friction < 10 * 1.1e-16);
    CHECK(audit.slip < 10 * 1.1e-16 * 225 * 225);
    // Every branch was met.
    CHECK(audit.apart > 10'000);
    CHECK(audit.sticks > 5'000);
    CHECK(audit.slides > 5'000);
    CHECK(audit.limited > 100);
}

TEST_CASE("an impact where sticking would gain energy stops short of it", "[impact][law]") {
    // A rod aslant that hits the floor with its tip; the impact throws the tip the way it slips already.
    const ImpactSide rod{.velocity = {-0.2, -2}, .inverseMass = 1, .inverseInertia = 12, .arm = {0.35, -0.35}};
    const double before = kinetic(rod, rod.velocity, rod.angularVelocity);
    // Restitution and no slip at once, by Cramer's rule: k jn - c jt = 4, -c jn + k jt = -0.2, jt along perp(normal).
    // What that gains: jt times the mean of the slip before, 0.2, and after, 0.
    const double c = 12 * 0.35 * 0.35, k = 1 + c, det = k * k - c * c;
    const double jn = (k * 4 - c * 0.2) / det, jt = (c * 4 - k * 0.2) / det;
    const double naive = jt * 0.2 / 2;
    const ImpactResult r = impact(floorSide, rod, {0, 1}, {.restitution = 1, .friction = 100});
    INFO("sticking: " << jn << ", " << jt << " gains " << naive << " J");
    const double gain = kinetic(rod, r.velocityB, r.angularVelocityB) - before;
    CHECK(naive > 0.01);
    CHECK_FALSE(r.sticks);
    CHECK(gain <= 1e-15 * before);
    CHECK(near(r.velocityB.y() + 0.35 * r.angularVelocityB, 2, 1e-14));  // restitution holds all the same
}

TEST_CASE("an impact is the same seen from either body", "[impact]") {
    Random random(53);
    for (int i = 0; i < 100; ++i) {
        const ImpactSide a = someSide(random);
        const ImpactSide b = someSide(random);
        const ImpactLaw law{random.uniform(0, 1), random.uniform(0, 1)};
        const ImpactResult r = impact(a, b, {0.6, 0.8}, law);
        const ImpactResult s = impact(b, a, {-0.6, -0.8}, law);
        CHECK(near(r.velocityA, s.velocityB, 1e-12));
        CHECK(near(r.angularVelocityB, s.angularVelocityA, 1e-12));
        CHECK(near(r.normalImpulse, s.normalImpulse, 1e-12));
        CHECK(near(r.tangentImpulse, s.tangentImpulse, 1e-12));
    }
}

TEST_CASE("bodies that part, graze or cannot move are left as they are", "[impact]") {
    const ImpactLaw law{.restitution = 1, .friction = 1};
    const auto spared = [](const ImpactResult& r) {
        return r.angularVelocityB == 3 && r.normalImpulse == 0 && r.tangentImpulse == 0 && !r.sticks;
    };
    for (const Vec2& velocity : {Vec2(1, 2), Vec2(1, 0)}) {
        const ImpactResult r = impact(floorSide, discOnFloor(velocity, 3), {0, 1}, law);
        CHECK(spared(r));
        CHECK(r.velocityB == velocity);
    }
    CHECK(spared(impact(floorSide, discOnFloor({1, notANumber}, 3), {0, 1}, law)));
    CHECK(spared(impact(floorSide, discOnFloor({1, -1}, 3), {notANumber, 1}, law)));
    CHECK(spared(impact(floorSide, discOnFloor({1, -infinity}, 3), {0, 1}, law)));
    const ImpactSide wall{.velocity = {0, -1}};
    CHECK(impact(floorSide, wall, {0, 1}, law).velocityB == Vec2(0, -1));
}

TEST_CASE("a body on a pivot bounces off by the law of restitution, whatever the friction", "[impact][law]") {
    // Only its turning answers: K is singular, and friction does nothing that the pivot does not.
    const ImpactSide rod{.angularVelocity = -4, .inverseInertia = 3, .arm = {1, 0.5}};
    for (const double friction : {0.0, 0.3, 5.0, infinity}) {
        const ImpactResult r = impact(floorSide, rod, {0, 1}, {.restitution = 0.5, .friction = friction});
        CHECK(near(r.angularVelocityB, 2, 1e-15));
        CHECK(r.velocityB == Vec2(0, 0));
    }
}

TEST_CASE("infinite friction never slips", "[impact]") {
    const ImpactResult r =
        impact(floorSide, discOnFloor({400, -3}), {0, 1}, {.restitution = 0.5, .friction = infinity});
    CHECK(r.sticks);
    CHECK(near(r.velocityB, {800.0 / 3, 1.5}, 1e-12));
}

// A belt is a wall whose surface moves: for what hits it, the same as a wall that moves as a whole.
TEST_CASE("10,000 impacts on a belt are those on a wall that moves as the belt's surface does", "[impact][law]") {
    Random random(12);
    for (int run = 0; run < 10000; ++run) {
        const Vec2 normal = Rot::fromAngle(random.uniform(-3, 3)) * Vec2(1, 0);
        const ImpactSide body{.velocity = {random.uniform(-5, 5), random.uniform(-5, 5)},
                              .angularVelocity = random.uniform(-9, 9),
                              .inverseMass = random.uniform(0.1, 3),
                              .inverseInertia = random.uniform(0, 9),
                              .arm = {random.uniform(-1, 1), random.uniform(-1, 1)}};
        const double speed = random.uniform(-8, 8);
        ImpactLaw law{.restitution = random.uniform(0, 1), .friction = random.uniform(0, 1)};
        const ImpactResult moving = impact({.velocity = -speed * perp(normal)}, body, normal, law);
        law.surfaceSpeed = speed;
        const ImpactResult belt = impact({}, body, normal, law);
        CHECK(near(belt.velocityB, moving.velocityB, 1e-12));
        CHECK(near(belt.angularVelocityB, moving.angularVelocityB, 1e-11));
        CHECK(belt.velocityA == Vec2(0, 0));
    }
}
