// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include <plumb/plumb.h>
#include "catch.h"
#include "kit/usual_world.h"

using namespace plumb;
using namespace plumb::test;

namespace {

struct Angle {
    double theta = 0, omega = 0;
};

/// theta'' = -k sin theta by the classical Runge-Kutta method in steps so small that its own error is below 1e-12.
Angle swung(Angle s, double k, double time) {
    const int steps = 200;
    const double h = time / steps;
    for (int i = 0; i < steps; ++i) {
        const auto f = [k](const Angle& a) { return Angle{a.omega, -k * std::sin(a.theta)}; };
        const auto at = [](const Angle& a, const Angle& d, double t) {
            return Angle{a.theta + d.theta * t, a.omega + d.omega * t};
        };
        const Angle k1 = f(s), k2 = f(at(s, k1, h / 2)), k3 = f(at(s, k2, h / 2)), k4 = f(at(s, k3, h));
        s.theta += h / 6 * (k1.theta + 2 * k2.theta + 2 * k3.theta + k4.theta);
        s.omega += h / 6 * (k1.omega + 2 * k2.omega + 2 * k3.omega + k4.omega);
    }
    return s;
}

/// How far a disc of radius 0.1 m on a 1 m arm strays from its swing in 4 s.
double pendulumError(double degrees, int rate) {
    World world({.gravity = {0, -g}});
    const double start = degrees * std::numbers::pi / 180;
    const BodyId pivot = world.add({.type = BodyType::Static});
    const BodyId bob = world.add({.position = {std::sin(start), -std::cos(start)}, .shapes = {circle(0.1)}});
    world.join(RevoluteJointDef{.bodyA = pivot, .bodyB = bob, .anchor = {0, 0}});
    const double k = g / (1 + 0.1 * 0.1 / 2);  // m g l / (m l^2 + m r^2 / 2)
    Angle truth{start, 0};
    double worst = 0;
    for (int tick = 0; tick < 4 * rate; ++tick) {
        world.step(1.0 / rate);
        truth = swung(truth, k, 1.0 / rate);
        const Vec2 there(std::sin(truth.theta), -std::cos(truth.theta));
        worst = std::max(worst, (world.body(bob).position() - there).norm());
    }
    return worst;
}

}  // namespace

TEST_CASE("a pendulum's error falls at least as the square of the step", "[dynamics][law]") {
    // From 120 Hz to 480 Hz, two halvings of the step. With longer steps it moves in pieces of them, which are finer.
    for (const double degrees : {45.0, 150.0}) {
        INFO(degrees << " degrees");
        const double at120 = pendulumError(degrees, 120), at480 = pendulumError(degrees, 480);
        CHECK(pendulumError(degrees, 15) < 3e-3);
        CHECK(at120 < 1.5e-4);
        CHECK(std::log2(at120 / at480) > 2 * 1.8);
    }
}

TEST_CASE("a 2 kg body hanging from a joint pulls on it with 19.62 N", "[dynamics][law]") {
    World world({.gravity = {0, -g}});
    const BodyId ceiling = world.add({.type = BodyType::Static});
    const Mass mass{2, {0, 0}, 0.1};
    const BodyId hinged = world.add({.position = {0, -1}, .mass = mass, .shapes = {circle(0.2)}});
    const BodyId hung = world.add({.position = {5, -1}, .mass = mass, .shapes = {circle(0.2)}});
    const JointId hinge = world.join(RevoluteJointDef{.bodyA = ceiling, .bodyB = hinged, .anchor = {0, 0}});
    const JointId rod =
        world.join(DistanceJointDef{.bodyA = ceiling, .bodyB = hung, .anchorA = {5, 0}, .anchorB = {5, -1}});
    for (int tick = 0; tick < 20; ++tick) world.step(1.0 / 60);
    CHECK(std::fabs(world.joint(hinge).reaction().force.y() - 19.62) < 1e-3);
    CHECK(std::fabs(world.joint(rod).reaction().force.y() - 19.62) < 1e-3);
    CHECK(std::fabs(world.joint(rod).reaction().force.x()) < 1e-6);
}

TEST_CASE("a rod pulls two bodies to its length when they start 0.2 m farther apart", "[dynamics]") {
    World world({.gravity = {0, 0}});
    const BodyId a = world.add({.position = {0, 0}, .shapes = {circle(0.1)}});
    const BodyId b = world.add({.position = {1.2, 0}, .shapes = {circle(0.1)}});
    world.join(DistanceJointDef{.bodyA = a, .bodyB = b, .anchorA = {0, 0}, .anchorB = {1.2, 0}, .length = 1.0});
    for (int tick = 0; tick < 120; ++tick) world.step(1.0 / 60);
    CHECK(std::fabs((world.body(b).position() - world.body(a).position()).norm() - 1) < 1e-4);
    CHECK(std::fabs((world.body(b).position() + world.body(a).position()).x() - 1.2) < 1e-5);
}

TEST_CASE("bodies joined without collideConnected pass through each other until the joint is removed", "[dynamics]") {
    World world({.gravity = {0, 0}});
    const BodyId a = world.add({.position = {0, 0}, .shapes = {circle(0.5)}});
    const BodyId b = world.add({.position = {0.5, 0}, .shapes = {circle(0.5)}});
    const JointId joint = world.join(RevoluteJointDef{.bodyA = a, .bodyB = b, .anchor = {0.25, 0}});
    for (int tick = 0; tick < 30; ++tick) world.step(1.0 / 60);
    CHECK(world.body(a).contacts().empty());
    CHECK((world.body(b).position() - world.body(a).position()).norm() < 0.5001);
    world.remove(joint);
    for (int tick = 0; tick < 120; ++tick) world.step(1.0 / 60);
    CHECK((world.body(b).position() - world.body(a).position()).norm() > 0.999);
}

TEST_CASE("a 30 by 30 grid of discs hung from seven joints stays together for ten seconds", "[dynamics]") {
    World world({.gravity = {0, -10}, .sleeping = false});
    constexpr int side = 30;
    std::vector<BodyId> discs;
    for (int k = 0; k < side; ++k) {
        for (int i = 0; i < side; ++i) {
            const bool fixed = i == 0 && std::abs(k - side / 2) <= 3;
            discs.push_back(world.add({.type = fixed ? BodyType::Static : BodyType::Dynamic,
                                       .position = Vec2(k, -i),
                                       .shapes = {{.shape = Circle{0.4}, .filter = {2, ~std::uint64_t{2}}}}}));
            const auto join = [&](int other, const Vec2& anchor) {
                const BodyId a = discs[static_cast<std::size_t>(other)];
                const BodyId b = discs.back();
                if (world.body(a).type() == BodyType::Static && fixed) return;
                world.join(RevoluteJointDef{.bodyA = a, .bodyB = b, .anchor = anchor});
            };
            if (i > 0) join(k * side + i - 1, {k, -i + 0.5});
            if (k > 0) join((k - 1) * side + i, {k - 0.5, -i});
        }
    }
    for (int tick = 0; tick < 600; ++tick) world.step(1.0 / 60);
    double worst = 0;
    for (int k = 0; k < side; ++k) {
        for (int i = 1; i < side; ++i) {
            const auto upper = world.body(discs[static_cast<std::size_t>(k * side + i - 1)]).pose();
            const auto lower = world.body(discs[static_cast<std::size_t>(k * side + i)]).pose();
            worst = std::max(worst, (upper * Vec2(0, -0.5) - lower * Vec2(0, 0.5)).norm());
        }
    }
    CHECK(worst < 0.05);  // 450 discs hang on each end; the joints give a little
}
