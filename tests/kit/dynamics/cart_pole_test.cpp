// SPDX-License-Identifier: MIT
// Does a pendulum on a light cart gain energy? Below the cart it turns by thousands of radians a second for a moment.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <plumb/math/random.h>
#include <plumb/plumb.h>
#include "cases.h"
#include "catch.h"

using namespace plumb;
using namespace plumb::test;

namespace {

struct CartPole {
    bool slide, hinge;  ///< else: locks, a rod
    double cart, length, gravity, rate;
    int subSteps;
};

/// By how much its energy exceeds that of the start, in 10 s, as a share of the fall.
double gainOf(const CartPole& c) {
    World world({.gravity = {0, -c.gravity}, .sleeping = false, .solver = {.subSteps = c.subSteps}});
    const BodyId ground = world.add({.type = BodyType::Static});
    BodyDef light{.mass = Mass{c.cart, {0, 0}, c.cart}};
    light.lockY = light.fixedRotation = !c.slide;
    const BodyId cart = world.add(light);
    if (c.slide) world.join(PrismaticJointDef{.bodyA = ground, .bodyB = cart, .anchor = {0, 0}, .axis = {1, 0}});
    const double inertia = 1e-4 * c.length * c.length;
    const BodyId pole = world.add({.position = {c.length, 0}, .mass = Mass{1, {0, 0}, inertia}});
    if (c.hinge)
        world.join(RevoluteJointDef{.bodyA = cart, .bodyB = pole, .anchor = {0, 0}});
    else
        world.join(DistanceJointDef{.bodyA = cart, .bodyB = pole, .anchorA = {0, 0}, .anchorB = {c.length, 0}});
    double most = 0;
    for (int tick = 0; tick < static_cast<int>(10 * c.rate); ++tick) {
        world.step(1 / c.rate);
        double energy = 0;
        for (const BodyView& body : {world.body(cart), world.body(pole)})
            energy += 0.5 * body.mass() * body.velocity().squaredNorm() +
                      0.5 * body.inertia() * body.angularVelocity() * body.angularVelocity() +
                      body.mass() * c.gravity * body.position().y();
        most = std::max(most, energy / (c.gravity * c.length));
    }
    return most;
}

}  // namespace

TEST_CASE("a light cart under a pendulum gains no energy, however coarse the step", "[dynamics][joints][law]") {
    // Without an account of what joints give, four in ten gain, up to thousands of times the fall.
    Random random(1);
    const auto spread = [&](double low, double high) { return low * std::pow(high / low, random.uniform(0, 1)); };
    const int runs = allCases(200);
    int gaining = 0;
    for (int i = 0; i < runs; ++i) {
        const bool slide = random.uniform(0, 1) < 0.5, hinge = random.uniform(0, 1) < 0.5;
        const double cart = spread(1e-9, 1), length = spread(0.1, 10), gravity = spread(1, 30);
        const double rate = std::round(spread(15, 1000));
        const CartPole one{slide, hinge, cart, length, gravity, rate, 1 << static_cast<int>(random.uniform(0, 4.999))};
        const double gain = gainOf(one);
        INFO("slide " << slide << ", hinge " << hinge << ", cart " << cart << " kg, " << length << " m, " << gravity
                      << " m/s^2, " << rate << " Hz, " << one.subSteps << ": " << gain);
        CHECK(gain < 0.15);
        gaining += gain > 2e-3 ? 1 : 0;
    }
    CHECK(gaining <= 0.02 * runs);
}

TEST_CASE("two balls on rods to a light link between them keep their momentum when they are thrown",
          "[dynamics][joints][law]") {
    for (const double light : {1.0, 1e-2, 1e-4})
        for (const double spin : {1.0, 10.0, 60.0}) {
            CAPTURE(light, spin);
            World world({.gravity = {0, 0}, .sleeping = false});
            std::vector<BodyId> balls;
            for (const double x : {0.0, 1.0, 2.0}) {
                const double mass = x == 1 ? light : 1;
                balls.push_back(world.add(
                    {.position = {x, 0}, .velocity = {5, spin * x}, .mass = Mass{mass, {0, 0}, 1e-2 * mass}}));
            }
            for (std::size_t i = 0; i < 2; ++i)
                world.join(DistanceJointDef{.bodyA = balls[i],
                                            .bodyB = balls[i + 1],
                                            .anchorA = world.body(balls[i]).position(),
                                            .anchorB = world.body(balls[i + 1]).position()});
            const auto momentum = [&] {
                Vec2 sum(0, 0);
                for (const BodyId ball : balls) sum += world.body(ball).mass() * world.body(ball).velocity();
                return sum;
            };
            const Vec2 start = momentum();
            for (int tick = 0; tick < 300; ++tick) world.step(1.0 / 60);
            CHECK((momentum() - start).norm() < 1e-9 * start.norm());
        }
}
