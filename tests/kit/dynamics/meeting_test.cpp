// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>

#include <plumb/impact/detail/meeting.h>
#include <plumb/math/random.h>
#include <plumb/plumb.h>
#include "catch.h"
#include "kit/usual_world.h"

using namespace plumb;
using namespace plumb::test;

namespace {

Material smooth(double restitution) {
    return {.friction = 0, .restitution = restitution};
}

/// A world with a wall along x = 0, which begins below the ground, and what is thrown at it from the left.
struct Throw {
    World world;
    BodyId body;

    Throw(double speed, double restitution, const ShapeDef& wall, ShapeDef thrown)
        : Throw(speed, restitution, wall, thrown, -0.5 - std::min(0.1, 0.2 * speed)) {}
    Throw(double speed, double restitution, const ShapeDef& wall, ShapeDef thrown, double x)
        : world({.gravity = {0, -g}, .sleeping = false}) {
        thrown.material = smooth(restitution);
        world.add({.type = BodyType::Static, .shapes = {wall}});
        body = world.add({.position = {x, 0}, .velocity = {speed, 0}, .shapes = {thrown}});
    }
    /// The speed from the wall, some time after the impact.
    double after(int ticks) {
        for (int tick = 0; tick < ticks; ++tick) world.step(dt);
        return -world.body(body).velocity().x();
    }
};

ShapeDef wallOf(double restitution) {
    return segment({0, -900}, {0, 900}, smooth(restitution));
}

/// It arrives after 0.2 s at most.
constexpr int untilAfter = 15;

double alone(double speed, double restitution) {
    return Throw(speed, restitution, wallOf(restitution), circle(0.5)).after(untilAfter);
}

double face(double speed, double restitution) {
    return Throw(speed, restitution, wallOf(restitution), box({0.5, 0.5})).after(untilAfter);
}

double atChain(double speed, double restitution) {
    return Throw(speed, restitution, chain({{0, -900}, {0, 0}, {0, 900}}, smooth(restitution)), circle(0.5))
        .after(untilAfter);
}

/// A disc that slides on the ground: the solver has its contacts.
double inLanes(double speed, double restitution) {
    Throw thrown(speed, restitution, wallOf(restitution), circle(0.5));
    thrown.world.add({.type = BodyType::Static, .shapes = {segment({-90, -0.5}, {90, -0.5}, smooth(0))}});
    return thrown.after(untilAfter);
}

/// On a rail.
double onRail(double speed, double restitution) {
    Throw thrown(speed, restitution, wallOf(restitution), circle(0.5));
    const BodyId rail = thrown.world.add({.type = BodyType::Static});
    thrown.world.join(PrismaticJointDef{
        .bodyA = rail, .bodyB = thrown.body, .anchor = thrown.world.body(thrown.body).position(), .axis = {1, 0}});
    return thrown.after(untilAfter);
}

/// Another disc strikes it, and it reaches the wall in the same step, past so many shapes that only the search after
/// the impacts sees the wall.
double inFlight(double speed, double restitution) {
    Throw thrown(0, restitution, wallOf(restitution), circle(0.1), -0.6 * speed * dt - 0.1);
    const double x = thrown.world.body(thrown.body).position().x();
    thrown.world.add({.position = {x - 0.2 - 1e-3, 0}, .velocity = {speed, 0}, .shapes = {circle(0.1, smooth(1))}});
    for (int i = 0; i < 210; ++i)
        thrown.world.add(
            {.type = BodyType::Static, .position = {x + 0.15 + (-x - 0.3) * i / 210, 0.15}, .shapes = {circle(0.001)}});
    return thrown.after(1);
}

/// On an arm that takes it off the straight way on which contacts are predicted, to a wall along the arm.
double inSubStep(double speed, double restitution) {
    World world({.gravity = {0, 0}, .sleeping = false, .solver = {.subSteps = 32}});
    const Vec2 along = Vec2(std::cos(1.0), std::sin(1.0));
    const double length = speed * dt / 1.5;
    const BodyId wall =
        world.add({.type = BodyType::Static,
                   .shapes = {segment(0.6 * length * along, 1.4 * length * along, smooth(restitution))}});
    const BodyId ball = world.add(
        {.position = {length, 0}, .velocity = {0, speed}, .shapes = {circle(0.02 * length, smooth(restitution))}});
    world.join(DistanceJointDef{
        .bodyA = wall, .bodyB = ball, .anchorA = {0, 0}, .anchorB = {length, 0}, .collideConnected = true});
    world.step(dt);
    const Vec2 arm = world.body(ball).position();
    return -cross(arm, world.body(ball).velocity()) / arm.norm();
}

/// Two loose bodies and the points where they meet.
struct RandomMeeting {
    std::array<LooseBody, 2> body;
    std::array<MeetingPoint, 2> points;
    Vec2 normal;
    ImpactLaw law;
};

RandomMeeting randomMeeting(Random& random) {
    RandomMeeting m;
    const auto vec = [&](double size) { return Vec2(random.uniform(-size, size), random.uniform(-size, size)); };
    for (LooseBody& one : m.body) {
        const Vec2 v = vec(10);
        one = {{v.x(), v.y(), random.uniform(-10, 10)}, random.uniform(0.01, 5), random.uniform(0, 20)};
    }
    if (random.integer(0, 2) == 0) m.body[0] = {};
    const double angle = random.uniform(0, 6.28);
    m.normal = Vec2(std::cos(angle), std::sin(angle));
    const Vec2 apart = vec(1), middle = vec(1);
    m.points[0] = {middle + perp(m.normal) * 0.5, middle + perp(m.normal) * 0.5 - apart};
    m.points[1] = {middle - perp(m.normal) * 0.5, middle - perp(m.normal) * 0.5 - apart};
    m.law = {random.uniform(0, 1), random.integer(0, 1) * random.uniform(0, 2), 0};
    return m;
}

double openingAt(const LooseBodies& bodies, const MeetingPoint& point, const Vec2& normal) {
    const OfBoth v = bodies.velocity();
    const auto at = [](const Vec3& speed, const Vec2& arm) { return Vec2(speed[0], speed[1]) + perp(arm) * speed[2]; };
    return Vec2(at(v.b, point.armB) - at(v.a, point.armA)).dot(normal);
}

double kineticOf(const LooseBody& body) {
    double energy = 0;
    if (body.inverseMass > 0)
        energy += 0.5 * (body.velocity[0] * body.velocity[0] + body.velocity[1] * body.velocity[1]) / body.inverseMass;
    if (body.inverseInertia > 0) energy += 0.5 * body.velocity[2] * body.velocity[2] / body.inverseInertia;
    return energy;
}

}  // namespace

TEST_CASE("a ball at a vertical wall comes back alike, whoever solves the impact", "[dynamics][impacts][law]") {
    struct Way {
        std::string name;
        std::function<double(double, double)> speedAfter;
        double slowest, fastest, tolerance;
    };
    // What joints hold bounces from half a step's gravity on, because they turn the pull. A step of the others that are
    // not solved at the moment of impact is exact to the roundings of floats.
    const Way ways[] = {{"alone", alone, 0.005, 100, 1e-9},         {"face", face, 0.005, 100, 1e-9},
                        {"chain", atChain, 0.005, 100, 1e-9},       {"lanes", inLanes, 0.005, 100, 1e-5},
                        {"jointed", onRail, 0.5, 100, 1e-5},        {"in flight", inFlight, 20, 300, 1e-9},
                        {"in a sub-step", inSubStep, 20, 300, 2e-3}};
    for (const Way& way : ways)
        for (const double restitution : {0.25, 0.5, 0.9, 1.0})
            for (const double speed : {0.005, 0.03, 0.1, 0.5, 3.0, 20.0, 60.0, 100.0, 300.0}) {
                if (speed < way.slowest || speed > way.fastest) continue;
                INFO(way.name << " at " << speed << " m/s, e = " << restitution);
                CHECK(std::fabs(way.speedAfter(speed, restitution) / (restitution * speed) - 1) < way.tolerance);
            }
}

TEST_CASE("at one point, 10,000 pairs of bodies part as the law of impacts says", "[dynamics][impacts][property]") {
    Random random(1);
    for (int round = 0; round < 10'000; ++round) {
        const RandomMeeting m = randomMeeting(random);
        LooseBodies both(m.body[0], m.body[1]);
        const auto sideOf = [&](const LooseBody& body, const Vec2& arm) {
            return ImpactSide{
                {body.velocity[0], body.velocity[1]}, body.velocity[2], body.inverseMass, body.inverseInertia, arm};
        };
        const ImpactResult wanted =
            impact(sideOf(m.body[0], m.points[0].armA), sideOf(m.body[1], m.points[0].armB), m.normal, m.law);
        const Meeting found = solveMeeting({m.points.data(), 1}, m.normal, m.law, 0, both);
        INFO("round " << round);
        CHECK(std::fabs(found.normalImpulse - wanted.normalImpulse) < 1e-9 * (1 + wanted.normalImpulse));
        CHECK(std::fabs(both.velocity().b[0] - wanted.velocityB.x()) < 1e-8);
        CHECK(std::fabs(both.velocity().a[2] - wanted.angularVelocityA) < 1e-8);
    }
}

TEST_CASE("at two points, 10,000 pairs of bodies part, keep their momentum and gain no energy",
          "[dynamics][impacts][property]") {
    Random random(2);
    for (int round = 0; round < 10'000; ++round) {
        const RandomMeeting m = randomMeeting(random);
        LooseBodies both(m.body[0], m.body[1]);
        const double first = openingAt(both, m.points[0], m.normal), second = openingAt(both, m.points[1], m.normal);
        const double before = kineticOf(both.a) + kineticOf(both.b);
        const Meeting found = solveMeeting(m.points, m.normal, m.law, 0, both);
        INFO("round " << round);
        if (first >= 0 && second >= 0) CHECK(found.normalImpulse == 0);
        // What pushes parts; nothing approaches any more.
        CHECK(openingAt(both, m.points[0], m.normal) > -1e-5);
        CHECK(openingAt(both, m.points[1], m.normal) > -1e-5);
        CHECK(kineticOf(both.a) + kineticOf(both.b) < before * (1 + 1e-9) + 1e-6);
        // What the impulses did is what the accounts say.
        const double change = kineticOf(both.a) + kineticOf(both.b) - before;
        CHECK(std::fabs(found.bounce + found.friction + found.drivers - change) < 1e-8 * (1 + before));
        if (m.body[0].inverseMass == 0) continue;
        for (std::size_t c = 0; c < 2; ++c) {
            const auto momentum = [c](const LooseBody& a, const LooseBody& b) {
                return a.velocity[c] / a.inverseMass + b.velocity[c] / b.inverseMass;
            };
            CHECK(std::fabs(momentum(both.a, both.b) - momentum(m.body[0], m.body[1])) < 1e-8 * (1 + before));
        }
    }
}

TEST_CASE("a machine at a stop that answers a large impulse otherwise is solved again", "[dynamics][impacts]") {
    // Twice as heavy from 1 N s on.
    struct Stop final : MeetingBodies {
        double speed = -3;
        OfBoth velocity() const override { return {{}, {speed, 0, 0}}; }
        OfBoth responseTo(const OfBoth& impulse) override { return {{}, {impulse.b[0], 0, 0}}; }
        void push(const OfBoth& impulse) override {
            speed += std::min(impulse.b[0], 1.0) + 0.5 * std::max(0.0, impulse.b[0] - 1);
        }
    } body;
    const MeetingPoint point;
    const Meeting found = solveMeeting({&point, 1}, {1, 0}, {0, 0, 0}, 0, body);
    CHECK(body.speed > -0.5);
    CHECK(found.normalImpulse > 3);
}
