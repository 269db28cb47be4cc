// SPDX-License-Identifier: MIT
// What does a limit do that is moved past a body?
#include <array>
#include <cmath>
#include <optional>
#include <variant>

#include <plumb/plumb.h>
#include "catch.h"
#include "kit/usual_world.h"
using namespace plumb;
using namespace plumb::test;

namespace {

struct Drive {
    double motorForce = 0, stiffness = 0;
};

/// A body that may move by 4 m or rad to both sides of where a joint of some kind holds it, with others behind it.
struct Stopped {
    World world;
    BodyId body;
    JointId joint;
    double length = 0;  ///< of its joint where its shift is 0 [m]
    bool turns = false;

    Stopped(int kind, double speed, const Drive& drive, int followers)
        : world({.gravity = {0, 0}, .sleeping = false}), length(kind == 2 ? 10 : 0), turns(kind == 1) {
        const BodyId fixed = world.add({.type = BodyType::Static});
        body = addAt(0, speed);
        joint = join(kind, fixed, drive);
        BodyId last = body;
        for (int i = 1; i <= followers; ++i) {
            const BodyId next = addAt(i, speed);
            world.join(PrismaticJointDef{.bodyA = last, .bodyB = next, .axis = {1, 0}, .limit = Limit{-0.1, 0.1}});
            last = next;
        }
        world.step(dt);
    }
    BodyId addAt(int place, double speed) {
        return world.add({.position = {length + 3 * place, 0},
                          .velocity = {turns ? 0 : speed, 0},
                          .angularVelocity = turns ? speed : 0,
                          .shapes = {{.shape = plumb::Circle{0.3}, .filter = {.mask = 0}}}});
    }
    JointId join(int kind, BodyId fixed, const Drive& drive) {
        const Vec2 at(length, 0);
        const Limit limit{-4, 4};
        std::optional<Spring> spring;
        if (drive.stiffness > 0) spring = Spring{drive.stiffness, 0};
        if (kind == 0)
            return world.join(PrismaticJointDef{.bodyA = fixed,
                                                .bodyB = body,
                                                .anchor = at,
                                                .axis = {1, 0},
                                                .limit = limit,
                                                .spring = spring,
                                                .maxMotorForce = drive.motorForce});
        if (kind == 1)
            return world.join(RevoluteJointDef{.bodyA = fixed,
                                               .bodyB = body,
                                               .anchor = at,
                                               .limit = limit,
                                               .spring = spring,
                                               .maxMotorTorque = drive.motorForce});
        if (kind == 2)
            return world.join(DistanceJointDef{.bodyA = fixed,
                                               .bodyB = body,
                                               .anchorB = at,
                                               .spring = Spring{drive.stiffness, 0},
                                               .minLength = length - 4,
                                               .maxLength = length + 4,
                                               .maxMotorForce = drive.motorForce});
        return world.join(WheelJointDef{.bodyA = fixed,
                                        .bodyB = body,
                                        .anchor = at,
                                        .axis = {1, 0},
                                        .limit = limit,
                                        .spring = spring,
                                        .maxMotorTorque = drive.motorForce});
    }
    void setLimit(const Limit& limit) {
        std::visit(
            [&](auto def) {
                if constexpr (requires { def.limit; }) def.limit = limit;
                if constexpr (requires { def.minLength; }) {
                    def.minLength = length + limit.lower;
                    def.maxLength = length + limit.upper;
                }
                if constexpr (
                    requires { def.axis; } || requires { def.maxMotorTorque; } || requires { def.minLength; })
                    world.joint(joint).set(def);
            },
            world.joint(joint).def());
    }
    double shift() const { return turns ? world.body(body).angle() : world.body(body).position().x() - length; }
    double speed() const { return turns ? world.body(body).angularVelocity() : world.body(body).velocity().x(); }
    void run(double seconds, double rate) {
        for (int tick = 0; tick < seconds * rate; ++tick) world.step(1 / rate);
    }
};

constexpr std::array<double, 3> coarseToFine{15, 60, 480};

}  // namespace

TEST_CASE("a limit moved 1 m past a body leaves it at the limit, with the speed that it had", "[dynamics][joints]") {
    for (int kind = 0; kind < 4; ++kind)
        for (const double side : {-1.0, 1.0})
            for (const double rate : coarseToFine)
                for (const double speed : {0.0, 0.5}) {
                    CAPTURE(kind, side, rate, speed);
                    Stopped one(kind, side * speed, {}, 0);
                    const double limit = one.shift() + side;
                    side > 0 ? one.setLimit({limit, 4}) : one.setLimit({-4, limit});
                    one.run(0.4, rate);
                    CHECK(one.shift() * side ==
                          Approx(limit * side + speed * 0.4 - speed / 3).margin(speed / rate + 1e-6));
                    CHECK(one.speed() == Approx(side * speed).margin(1e-6));
                }
}

TEST_CASE("a body set 1 m beyond its limit comes back to it, and keeps its speed", "[dynamics][joints]") {
    for (const int kind : {0, 2, 3})
        for (const double side : {-1.0, 1.0})
            for (const double rate : coarseToFine) {
                CAPTURE(kind, side, rate);
                Stopped one(kind, -0.5 * side, {}, 0);
                one.world.body(one.body).setPose({one.length + 5 * side, 0}, 0);
                one.run(0.4, rate);
                CHECK(one.shift() * side < 4 + 1e-6);
                CHECK(one.shift() * side > 3.9);
                CHECK(one.speed() == Approx(-0.5 * side).margin(1e-6));
            }
}

TEST_CASE("a limit that moves a row of bodies by their limits, or against a brake, leaves them no speed",
          "[dynamics][joints]") {
    for (int kind = 0; kind < 4; ++kind)
        for (const double side : {-1.0, 1.0})
            for (const double rate : coarseToFine)
                for (const int followers : {0, 2}) {
                    const Drive drive{.motorForce = followers == 0 ? 5.0 : 0.0, .stiffness = 0};
                    CAPTURE(kind, side, rate, followers);
                    Stopped one(kind, 0, drive, kind == 1 ? 0 : followers);
                    const double limit = one.shift() + side;
                    side > 0 ? one.setLimit({limit, 4}) : one.setLimit({-4, limit});
                    one.run(1, rate);
                    CHECK(one.shift() == Approx(limit).margin(1e-5));
                    CHECK(std::fabs(one.speed()) < 1e-5);
                }
}
