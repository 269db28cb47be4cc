// SPDX-License-Identifier: MIT
// Worked numbers of response for which the kit has no closed form of its own: statics, and machines
// in a world.
#include <cmath>
#include <iostream>

#include <Eigen/LU>

#include <plumb/plumb.h>

#include "catch.h"
#include "kit/dynamics/worlds.h"
#include "kit/forces/runge_kutta.h"
#include "kit/usual_world.h"

using namespace plumb;
using namespace plumb::test;

namespace {

constexpr double digits = 0.5e-10;  // worked numbers stand to ten decimals

double degrees(double angle) {
    return angle * M_PI / 180;
}

/// 3 kg and 2 kg on a rope over a wheel of 1 kg that it turns: racks on a pinion, as it does not slip.
struct HeavyAtwood {
    World world{{.sleeping = false}};
    BodyId heavy, light;

    explicit HeavyAtwood(double wheelMass) {
        const double radius = 0.3;
        const BodyId frame = world.add({.type = BodyType::Static});
        const BodyId wheel = world.add({.mass = Mass{wheelMass, {0, 0}, wheelMass * radius * radius / 2}});
        heavy = world.add({.position = {radius, 0}, .mass = Mass{3, {0, 0}, 1}});
        light = world.add({.position = {-radius, 0}, .mass = Mass{2, {0, 0}, 1}});
        const JointId axle = world.join(RevoluteJointDef{.bodyA = frame, .bodyB = wheel});
        const auto hang = [&](BodyId weight, const Vec2& anchor, double ratio) {
            const JointId guide =
                world.join(PrismaticJointDef{.bodyA = frame, .bodyB = weight, .anchor = anchor, .axis = {0, 1}});
            world.join(GearJointDef{.jointA = axle, .jointB = guide, .ratio = ratio});
        };
        hang(heavy, {radius, 0}, -1 / radius);
        hang(light, {-radius, 0}, 1 / radius);
    }
};

/// Newton's and Euler's laws for the three of them, solved: acceleration [m/s^2], pull on the heavy and the light [N].
Eigen::Vector3d atwoodByNewton(double wheelMass) {
    Eigen::Matrix3d laws;
    laws << 3, 1, 0,           // m1 a = m1 g - T1
        2, 0, -1,              // m2 a = T2 - m2 g
        wheelMass / 2, -1, 1;  // (M r^2 / 2) (a / r) = (T1 - T2) r
    return laws.inverse() * Eigen::Vector3d(3 * g, -2 * g, 0);
}

/// Angles of two rods of 1 m with 1 kg at each end, from straight down, and how fast they turn.
test::State<4> doublePendulumRate(const test::State<4>& s) {
    // Lagrange's equations: 2 a1 + a2 cos d = -w2^2 sin d - 2 g sin t1,  a1 cos d + a2 = w1^2 sin d - g sin t2.
    const double d = s[0] - s[1], c = std::cos(d), sine = std::sin(d);
    const double first = -s[3] * s[3] * sine - 2 * g * std::sin(s[0]);
    const double second = s[2] * s[2] * sine - g * std::sin(s[1]);
    const double det = 2 - c * c;
    return {s[2], s[3], (first - c * second) / det, (2 * second - c * first) / det};
}

double doublePendulumEnergy(const test::State<4>& s) {
    const double kinetic = s[2] * s[2] + s[3] * s[3] / 2 + s[2] * s[3] * std::cos(s[0] - s[1]);
    return kinetic - g * (2 * std::cos(s[0]) + std::cos(s[1]));
}

/// A block of 0.5 m by 1 m on a slope down to the right, that cannot slide: how far it has turned after 4 s [rad].
double turnOnSlope(double slope) {
    World world({.sleeping = false});  // what leans on its corner, or tips by so little, moves too slowly to stay awake
    const Rot turn = Rot::fromAngle(-slope);
    const Material rough{.friction = 2};
    world.add({.type = BodyType::Static, .angle = -slope, .shapes = {segment({-3, 0}, {3, 0}, rough)}});
    const BodyId block =
        world.add({.position = turn * Vec2(-0.25, 0.5), .angle = -slope, .shapes = {box({0.25, 0.5}, rough)}});
    run(world, 4);
    return world.body(block).angle() + slope;
}

/// Each block's right end stands out over the one below as far as the centre of mass of it and those above may: up to
/// just over that end. How far the topmost stands out over the table, in lengths of a block.
double overhangByBalance(int blocks) {
    double center = 0;  // of those put up so far, from the right end of the topmost
    for (int i = 0; i < blocks; ++i) {
        const double right = center;  // the next block's end is just below it
        center = (center * i + right - 0.5) / (i + 1);
    }
    return -center;
}

/// A stack of four blocks of 1 m over the edge of a table, each overhang the given part of what balances.
bool standsOut(double part) {
    World world({.sleeping = false});
    world.add({.type = BodyType::Static, .position = {-5, -0.5}, .shapes = {box({5, 0.5})}});
    std::vector<BodyId> blocks;
    double end = 0;
    for (int fromTop = 4; fromTop >= 1; --fromTop) {
        end += part / (2 * fromTop);
        blocks.push_back(world.add({.position = {end - 0.5, 0.1 + 0.2 * (4 - fromTop)}, .shapes = {box({0.5, 0.1})}}));
    }
    run(world, 5);
    return world.body(blocks.back()).position().y() > 0.65;
}

}  // namespace

// Worked numbers of response, Atwood: g (m1 - m2) / (m1 + m2 + M / 2), with a wheel of M = 1 kg, and of none.
TEST_CASE("3 kg beside 2 kg over a wheel of 1 kg fall at 1.7836363636 m/s^2", "[dynamics][facts][law]") {
    CHECK(std::fabs(atwoodByNewton(1).x() - 1.7836363636) < digits);
    HeavyAtwood machine(1);
    run(machine.world, 1);
    const double fallen = -machine.world.body(machine.heavy).position().y();
    CHECK(std::fabs(2 * fallen - 1.7836363636) < 1e-4);  // constant forces: second order is exact, but for floats
    CHECK(std::fabs(machine.world.body(machine.heavy).velocity().y() + 1.7836363636) < 1e-4);
    CHECK(std::fabs(machine.world.body(machine.light).position().y() - fallen) < 1e-4);
}

TEST_CASE("3 kg beside 2 kg on a pulley fall at 1.962 m/s^2 and pull the rope with 23.544 N",
          "[dynamics][facts][law]") {
    CHECK((atwoodByNewton(0) - Eigen::Vector3d(1.962, 23.544, 23.544)).norm() < 1e-13);
    World world({.sleeping = false});
    const BodyId heavy = world.add({.position = {1, 0}, .mass = Mass{3, {0, 0}, 1}});
    const BodyId light = world.add({.position = {-1, 0}, .mass = Mass{2, {0, 0}, 1}});
    const JointId rope = world.join(PulleyJointDef{
        .bodyA = heavy, .bodyB = light, .groundA = {1, 4}, .groundB = {-1, 4}, .anchorA = {1, 0}, .anchorB = {-1, 0}});
    run(world, 1);
    CHECK(std::fabs(-2 * world.body(heavy).position().y() - 1.962) < 1e-4);
    CHECK(std::fabs(world.joint(rope).reaction().force.norm() - 23.544) < 0.01);  // of an impulse in single precision
}

// Worked numbers of response, stack (Hall 2005): N_i = i m g.
TEST_CASE("under ten boxes of 1 kg the floor bears 98.1 N, and the contact over each bears what is above",
          "[dynamics][facts][law]") {
    World world({.sleeping = false});
    world.add({.type = BodyType::Static, .position = {0, -0.5}, .shapes = {box({10, 0.5})}});
    std::vector<BodyId> boxes;
    for (int i = 0; i < 10; ++i)
        boxes.push_back(world.add({.position = {0, 0.5 + i}, .shapes = {box({0.5, 0.5}, {.density = 1})}}));
    run(world, 10);
    double worst = 0;
    for (std::size_t i = 0; i < 10; ++i) {
        double borne = 0;
        for (const Contact& contact : world.body(boxes[i]).contacts())
            for (const ContactPoint& point : contact.points)
                if (point.position.y() < world.body(boxes[i]).position().y()) borne += point.normalForce;
        worst = std::max(worst, std::fabs(borne - static_cast<double>(10 - i) * g));
    }
    std::cout << "dynamics: contacts in a stack of ten bear their weights to " << worst << " N\n";
    CHECK(worst < 1e-3);  // of 98 N, in single precision, at rest
}

TEST_CASE("four blocks reach out over a table by 1.0416666667 of their length, and no further",
          "[dynamics][facts][law]") {
    CHECK(std::fabs(overhangByBalance(4) - 1.0416666667) < digits);
    CHECK(standsOut(0.97));  // contacts give way by a third of a millimetre a weight: of 1/8 m they take some 2 %
    CHECK_FALSE(standsOut(1.01));
}

// Worked numbers of response, block tip (statics): tan t = b / h, 1/2.
TEST_CASE("a block twice as high as wide stands up to 26.565051177 degrees, and falls beyond",
          "[dynamics][facts][law]") {
    // The slope at which its centre is over the lower corner, by bisection.
    double low = 0, high = degrees(90);
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        const bool inside = (Rot::fromAngle(-middle) * Vec2(-0.25, 0.5)).x() < 0;
        (inside ? low : high) = middle;
    }
    CHECK(std::fabs(low * 180 / M_PI - 26.565051177) < 0.5e-9);
    CHECK(std::fabs(turnOnSlope(degrees(26.565051177 - 0.05))) < 1e-3);  // it sinks in by a tenth of a millimetre
    CHECK(turnOnSlope(degrees(26.565051177 + 0.05)) < -0.5);
}

// Worked numbers of response, double pendulum: 1 m, 1 kg each, let go at 60 and 0 degrees.
TEST_CASE("a double pendulum let go at 60 and 0 degrees is at -0.3594603007 and -0.6464394724 rad after 1 s",
          "[dynamics][facts][law]") {
    const test::State<4> start(degrees(60), 0, 0, 0);
    CHECK(std::fabs(doublePendulumEnergy(start) + 19.62) < 1e-14);
    const test::State<4> end = test::integrated<4>(start, 1, 10'000, doublePendulumRate);
    CHECK((end - test::State<4>(-0.3594603007, -0.6464394724, 2.0086394334, -4.8922131911)).norm() < 2 * digits);
    CHECK(std::fabs(doublePendulumEnergy(end) + 19.62) < 1e-11);

    const auto errorAt = [](double step) {
        World world({.sleeping = false});
        const BodyId hook = world.add({.type = BodyType::Static});
        const Vec2 elbow(std::sin(degrees(60)), -std::cos(degrees(60)));
        const BodyId upper = world.add({.position = elbow, .mass = Mass{1, {0, 0}, 1}});
        const BodyId lower = world.add({.position = elbow + Vec2(0, -1), .mass = Mass{1, {0, 0}, 1}});
        world.join(DistanceJointDef{.bodyA = hook, .bodyB = upper, .anchorA = {0, 0}, .anchorB = elbow});
        world.join(DistanceJointDef{.bodyA = upper, .bodyB = lower, .anchorA = elbow, .anchorB = elbow + Vec2(0, -1)});
        run(world, 1, step);
        const Vec2 a = world.body(upper).position(), b = world.body(lower).position();
        const Vec2 expected(std::sin(-0.3594603007), -std::cos(-0.3594603007));
        const Vec2 end2 = expected + Vec2(std::sin(-0.6464394724), -std::cos(-0.6464394724));
        return std::max((a - expected).norm(), (b - end2).norm());
    };
    const double coarse = errorAt(1.0 / 60), fine = errorAt(1.0 / 120);
    std::cout << "dynamics: a double pendulum is off by " << coarse << " m after 1 s at 60 Hz, " << fine
              << " m at 120 Hz\n";
    CHECK(coarse < 1e-3);
    CHECK(fine < coarse / 3);
}

TEST_CASE("a double pendulum's modes take 2.6210524301 s and 1.0856754642 s", "[dynamics][facts][law]") {
    // At an amplitude of 1e-6 the swing takes longer by some 1e-12 of its period.
    const auto late = [](double ratio, double period) {
        const test::State<4> end =
            test::integrated<4>(test::State<4>(1e-6, ratio * 1e-6, 0, 0), period, 20'000, doublePendulumRate);
        return -end[2] / doublePendulumRate(end)[2];
    };
    CHECK(std::fabs(late(std::sqrt(2.0), 2.6210524301)) < 2e-10);
    CHECK(std::fabs(late(-std::sqrt(2.0), 1.0856754642)) < 2e-10);
}
