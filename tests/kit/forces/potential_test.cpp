// SPDX-License-Identifier: MIT
// What all forces with a potential have in common.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

#include <plumb/forces/attractor.h>
#include <plumb/forces/buoyancy.h>
#include <plumb/forces/gravity.h>
#include <plumb/forces/magnet.h>
#include <plumb/forces/spring.h>
#include <plumb/math/random.h>
#include <plumb/math/rot.h>

#include "cases.h"
#include "catch.h"

using namespace plumb;

namespace {

Vec2 randomVec2(Random& random, double size) {
    const double x = random.uniform(-size, size);
    return {x, random.uniform(-size, size)};
}

/// From a to 1 / a, evenly in its logarithm.
double randomSize(Random& random, double least) {
    return std::exp(random.uniform(std::log(least), -std::log(least)));
}

/// Any way, by 0.1 to 10.
Vec2 randomOffset(Random& random) {
    const Vec2 direction = randomVec2(random, 1).normalized();
    return direction * randomSize(random, 0.1);
}

/// The derivative at 0 by differences of fourth order: off by h^4 / 30 of the fifth derivative, and by 3 / (2 h) of the
/// rounding of the values.
template <typename Energy>
double slope(double h, const Energy& energy) {
    return (8 * (energy(h) - energy(-h)) - (energy(2 * h) - energy(-2 * h))) / (12 * h);
}

template <typename Energy>
Vec2 gradient(double h, const Energy& energy) {
    return {slope(h, [&](double x) { return energy(Vec2(x, 0)); }),
            slope(h, [&](double y) { return energy(Vec2(0, y)); })};
}

// Powers of the distance q up to the eighth: a step h = 1e-3 q is off by h^4 / 30 of the fifth derivative, for q^-7
// 7 8 9 10 11 / q^5 of it, so by 2e-9 of U / q; rounding by some 10 roundings of 1.1e-16 times 1.5e3, for the sums of
// places up to 5 m at distances from 0.1 m on once more 1e2.
constexpr double step = 1e-3, tolerance = 5e-9;

double attractorError(Random& random) {
    Attractor attractor{.center = randomVec2(random, 5),
                        .strength = random.uniform(-10, 10),
                        .power = random.integer(1, 8),
                        .softening = random.integer(0, 1) == 0 ? 0 : randomSize(random, 0.1)};
    const Vec2 place = attractor.center + randomOffset(random);
    const double d = (place - attractor.center).norm();
    const double q = std::hypot(d, attractor.softening);
    if (random.integer(0, 1) == 0) attractor.range = d + 0.01 * q;
    const Vec2 uphill = gradient(step * q, [&](const Vec2& r) { return potentialEnergy(attractor, Vec2(place + r)); });
    const double size = std::fabs(attractor.strength) / std::pow(q, attractor.power);
    return (uphill + attraction(attractor, place)).norm() / size;
}

double mutualGravityError(Random& random) {
    const MutualGravity gravity{.constant = random.uniform(0, 10),
                                .softening = random.integer(0, 1) == 0 ? 0 : randomSize(random, 0.1)};
    const PointMass a{randomSize(random, 0.01), randomVec2(random, 5)};
    PointMass b{randomSize(random, 0.01), {0, 0}};
    b.position = a.position + randomOffset(random);
    const double q = std::hypot((b.position - a.position).norm(), gravity.softening);
    const Vec2 uphill = gradient(step * q, [&](const Vec2& r) {
        return potentialEnergy(gravity, a, {b.mass, b.position + r});
    });
    return (uphill + gravityForce(gravity, a, b)).norm() * q * q / (gravity.constant * a.mass * b.mass);
}

double uniformGravityError(Random& random) {
    const UniformGravity gravity{randomVec2(random, 20)};
    const double mass = randomSize(random, 0.01);
    const Vec2 place = randomVec2(random, 5);
    const Vec2 uphill = gradient(1, [&](const Vec2& r) { return potentialEnergy(gravity, mass, Vec2(place + r)); });
    return (uphill + gravityForce(gravity, mass)).norm() / (mass * gravity.acceleration.norm());
}

double springError(Random& random) {
    const SpringDamper spring{.stiffness = randomSize(random, 0.01), .restLength = random.uniform(0, 5)};
    const Vec2 a = randomVec2(random, 5);
    const Vec2 b = a + randomOffset(random);
    const double d = (b - a).norm();
    const Vec2 uphill = gradient(step * d, [&](const Vec2& r) { return potentialEnergy(spring, a, Vec2(b + r)); });
    // The energy is d^2 / 2 - L d and a constant: the fifth derivative is that of L d, and the constant is only
    // rounded.
    const double size = spring.stiffness * (d + spring.restLength) * (1 + spring.restLength / d);
    return (uphill + springForce(spring, {a, {0, 0}}, {b, {0, 0}})).norm() / size;
}

double magnetError(Random& random) {
    const Magnetism law{.constant = randomSize(random, 0.01),
                        .softening = random.integer(0, 1) == 0 ? 0 : randomSize(random, 0.1)};
    const Dipole a{randomVec2(random, 5), randomVec2(random, 3)};
    const Vec2 place = a.position + randomOffset(random);
    const Vec2 moment = randomVec2(random, 3);
    const double q = std::hypot((place - a.position).norm(), law.softening);
    const MagnetPull pull = magnetPull(law, a, {place, moment});
    const double size = law.constant * a.moment.norm() * moment.norm() / (q * q * q);
    const Vec2 uphill = gradient(step * q, [&](const Vec2& r) { return potentialEnergy(law, a, {place + r, moment}); });
    const double turned = slope(step, [&](double angle) {
        return potentialEnergy(law, a, {place, Rot::fromAngle(angle) * moment});
    });
    return std::max((uphill + pull.force).norm() * q, std::fabs(turned + pull.torque)) / size;
}

struct Floater {
    std::vector<Vec2> corners = {};
    double radius = 0;
};

/// A circle, a capsule, a box, rounded or not, or a star, about as large as its size.
Floater randomFloater(Random& random, double size) {
    Floater floater{.radius = size * random.uniform(0.05, 0.5)};
    const int kind = random.integer(0, 4);
    const double wide = size * random.uniform(0.2, 1), high = size * random.uniform(0.2, 1);
    if (kind == 0) floater.corners = {randomVec2(random, size)};
    if (kind == 1) floater.corners = {{-wide, 0.3 * size}, {wide, 0.1 * size}};
    if (kind == 2 || kind == 3) floater.corners = {{-wide, -high}, {wide, -high}, {wide, high}, {-wide, high}};
    if (kind >= 3) floater.radius = 0;
    for (int i = 0; kind == 4 && i < 10; ++i) {
        const Rot turn = Rot::fromAngle(0.2 * M_PI * i);
        floater.corners.push_back(turn * Vec2((i % 2 == 0 ? 1 : 0.4) * size, 0));
    }
    return floater;
}

Submerged partOf(const Floater& floater, const Vec2& shift, const Rot& turn, const Fluid& fluid) {
    std::vector<Vec2> placed;
    for (const Vec2& corner : floater.corners) placed.push_back(turn * corner + shift);
    return submergedPart(placed, floater.radius, fluid);
}

// Where a corner or a level side passes the surface, the force has a kink, its slope a step of at most rho g times the
// size 6 L across: differences over 4 h are off by as much as 4 h of it. Off by h ^ 4 elsewhere, and by 1.5 / h = 1.5e6
// of some 10 roundings of 1.1e-16, of an energy of up to 5 times rho g L^3.
double buoyancyError(Random& random) {
    const double size = randomSize(random, 0.1), h = 1e-6;
    const Fluid fluid{
        .density = randomSize(random, 0.01), .surface = randomVec2(random, 2), .gravity = randomVec2(random, 9)};
    const Floater floater = randomFloater(random, size);
    const Vec2 place = fluid.surface + randomVec2(random, 2 * size);
    const double angle = random.uniform(-3, 3);
    const Submerged part = partOf(floater, place, Rot::fromAngle(angle), fluid);
    const Vec2 force = buoyancyForce(fluid, part);
    const Vec2 uphill = gradient(h * size, [&](const Vec2& r) {
        return potentialEnergy(fluid, partOf(floater, place + r, Rot::fromAngle(angle), fluid));
    });
    const double turned = slope(h, [&](double more) {
        return potentialEnergy(fluid, partOf(floater, place, Rot::fromAngle(angle + more), fluid));
    });
    const double torque = part.area > 0 ? cross(part.centroid - place, force) : 0;
    return std::max((uphill + force).norm() * size, std::fabs(turned + torque)) /
           (fluid.density * fluid.gravity.norm() * size * size * size);
}

double worstOf(const std::string& what, int places, double (*errorOf)(Random&)) {
    Random random(71);
    double worst = 0;
    int at = -1;
    for (int i = 0; i < places; ++i) {
        const double error = errorOf(random);
        if (!(error <= worst)) worst = error, at = i;
    }
    std::cout << "forces: " << what << ": the energy's slope is off by at most " << worst << " (place " << at << " of "
              << places << ")\n";
    return worst;
}

}  // namespace

TEST_CASE("the slope of every potential energy is its force, in 100,000 places each", "[forces][law]") {
    const int places = test::cases(100'000);
    CHECK(worstOf("uniform gravity", places, uniformGravityError) < 1e-13);
    CHECK(worstOf("mutual gravity", places, mutualGravityError) < tolerance);
    CHECK(worstOf("spring", places, springError) < tolerance);
    CHECK(worstOf("attractor", places, attractorError) < tolerance);
    CHECK(worstOf("magnet, and turned", places, magnetError) < tolerance);
    CHECK(worstOf("buoyancy, and turned", places, buoyancyError) < 4e-6 * 6 + 5 * 1e-15 * 1.5e6);
}

TEST_CASE("what pulls in pairs pulls both alike, to the last bit, 100,000 times", "[forces][law]") {
    Random random(72);
    int differ = 0;
    for (int i = 0; i < test::cases(100'000); ++i) {
        const MutualGravity gravity{.constant = 3, .softening = random.uniform(0, 1)};
        const PointMass a{random.uniform(0, 9), randomVec2(random, 5)}, b{random.uniform(0, 9), randomVec2(random, 5)};
        differ += gravityForce(gravity, a, b) != -gravityForce(gravity, b, a);
        const SpringDamper spring{.stiffness = 7, .damping = 2, .restLength = random.uniform(0, 3)};
        const SpringEnd c{a.position, randomVec2(random, 3)}, d{b.position, randomVec2(random, 3)};
        differ += springForce(spring, c, d) != -springForce(spring, d, c);
    }
    CHECK(differ == 0);
}
