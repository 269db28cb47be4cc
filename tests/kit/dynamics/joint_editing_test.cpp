// SPDX-License-Identifier: MIT
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <plumb/math/random.h>
#include <plumb/plumb.h>
#include "catch.h"
#include "kit/usual_world.h"
using namespace plumb;
using namespace plumb::test;

namespace {

struct Place {
    Vec2 position;
    double angle;
    Transform pose() const { return {position, Rot::fromAngle(angle)}; }
};

Vec2 pointIn(Random& random, double reach) {
    const double x = random.uniform(-reach, reach);
    return {x, random.uniform(-reach, reach)};
}

Place placeIn(Random& random) {
    const Vec2 position = pointIn(random, 3);
    return {position, random.uniform(-3, 3)};
}

/// A joint between two bodies as its words say: where they were when it was made, and how far off it is.
struct Seen {
    Place a, b;
    Vec2 anchorA, anchorB;  ///< in the world, when it was made
    Vec2 shift(const Place& nowA, const Place& nowB) const {
        return nowB.pose() * (b.pose().inverse() * anchorB) - nowA.pose() * (a.pose().inverse() * anchorA);
    }
    double turn(const Place& nowA, const Place& nowB) const { return (nowB.angle - nowA.angle) - (b.angle - a.angle); }
    Vec2 axis(const Place& nowA, const Vec2& given) const {
        return Rot::fromAngle(nowA.angle - a.angle) * given.normalized();
    }
};

/// What a kind of joint should say of its coordinate and errors.
struct JointSort {
    std::string name;
    JointDef def;
    std::function<double(const Place&, const Place&)> coordinate, error;
    bool turns = true;  ///< whatever way it is turned is right
};

std::vector<JointSort> kindsBetween(BodyId a, BodyId b, const Place& atA, const Place& atB, Random& random) {
    const Vec2 p = pointIn(random, 4), q = pointIn(random, 4), way = pointIn(random, 1) + Vec2(2, 0);
    const Vec2 groundA = pointIn(random, 5), groundB = pointIn(random, 5);
    const double ratio = random.uniform(0.5, 2);
    const Seen one{atA, atB, p, p}, two{atA, atB, p, q};
    const auto gap = [one](const Place& x, const Place& y) { return one.shift(x, y).norm(); };
    const auto turn = [one](const Place& x, const Place& y) { return one.turn(x, y); };
    const auto along = [=](const Place& x, const Place& y) { return one.axis(x, way).dot(one.shift(x, y)); };
    const auto aside = [=](const Place& x, const Place& y) {
        return std::fabs(cross(one.axis(x, way), one.shift(x, y)));
    };
    const auto length = [two](const Place& x, const Place& y) { return two.shift(x, y).norm(); };
    const auto rope = [=](const Place& x, const Place& y) {
        const Vec2 onA = x.pose() * (atA.pose().inverse() * p), onB = y.pose() * (atB.pose().inverse() * q);
        return (onA - groundA).norm() + ratio * (onB - groundB).norm();
    };
    const auto none = [](const Place&, const Place&) { return 0.0; };
    const auto off = [=](const Place& x, const Place& y) {
        return ((x.pose().inverse() * y.position) - (atA.pose().inverse() * atB.position)).norm();
    };
    const auto missed = [=](const Place&, const Place& y) {
        return (y.pose() * (atB.pose().inverse() * p) - q).norm();
    };
    return {
        {"revolute", RevoluteJointDef{.bodyA = a, .bodyB = b, .anchor = p}, turn, gap},
        {"prismatic", PrismaticJointDef{.bodyA = a, .bodyB = b, .anchor = p, .axis = way}, along, aside, false},
        {"rod", DistanceJointDef{.bodyA = a, .bodyB = b, .anchorA = p, .anchorB = q}, length,
         [=](const Place& x, const Place& y) { return std::fabs(length(x, y) - (q - p).norm()); }},
        {"weld", WeldJointDef{.bodyA = a, .bodyB = b, .anchor = p}, turn, gap, false},
        {"wheel", WheelJointDef{.bodyA = a, .bodyB = b, .anchor = p, .axis = way}, along, aside},
        {"pulley",
         PulleyJointDef{.bodyA = a,
                        .bodyB = b,
                        .groundA = groundA,
                        .groundB = groundB,
                        .anchorA = p,
                        .anchorB = q,
                        .ratio = ratio},
         rope, [=](const Place& x, const Place& y) { return std::max(0.0, rope(x, y) - rope(atA, atB)); }},
        {"motor", MotorJointDef{.bodyA = a, .bodyB = b, .maxForce = 1}, off, none},
        {"target", TargetJointDef{.body = b, .anchor = p, .target = q}, missed, none},
    };
}

BodyDef bodyAt(const Place& place) {
    return {.position = place.position, .angle = place.angle, .shapes = {circle(0.5), box({1, 0.2})}};
}

Place moved(const Place& place, const Vec2& velocity, double spin, double time) {
    return {place.position + velocity * time, place.angle + spin * time};
}

}  // namespace

TEST_CASE("coordinate, speed and errors of each kind of joint are what 1,000 seeded pairs of poses say",
          "[dynamics][joints]") {
    Random random(41);
    double worstValue = 0, worstSpeed = 0, worstError = 0;
    for (int i = 0; i < 1000; ++i) {
        const Place atA = placeIn(random), atB = placeIn(random), toA = placeIn(random), toB = placeIn(random);
        World world({.gravity = {0, 0}});
        const BodyId a = world.add(bodyAt(atA)), b = world.add(bodyAt(atB));
        std::vector<JointId> joints;
        const std::vector<JointSort> kinds = kindsBetween(a, b, atA, atB, random);
        for (const JointSort& kind : kinds) joints.push_back(world.join(kind.def));
        const Vec2 velocityA = pointIn(random, 2), velocityB = pointIn(random, 2);
        const double spinA = random.uniform(-2, 2), spinB = random.uniform(-2, 2);
        world.body(a).setPose(toA.position, toA.angle);
        world.body(b).setPose(toB.position, toB.angle);
        world.body(a).setVelocity(velocityA), world.body(a).setAngularVelocity(spinA);
        world.body(b).setVelocity(velocityB), world.body(b).setAngularVelocity(spinB);
        for (std::size_t k = 0; k < kinds.size(); ++k) {
            const auto value = [&](double time) {
                return kinds[k].coordinate(moved(toA, velocityA, spinA, time), moved(toB, velocityB, spinB, time));
            };
            const JointView joint = world.joint(joints[k]);
            worstValue = std::max(worstValue, std::fabs(joint.coordinate().value - value(0)));
            worstError = std::max(worstError, std::fabs(joint.error() - kinds[k].error(toA, toB)));
            const double turned = kinds[k].turns ? 0.0 : std::fabs((toB.angle - toA.angle) - (atB.angle - atA.angle));
            worstError = std::max(worstError, std::fabs(joint.angleError() - turned));
            // Distances that have shrunk to nearly nothing turn too fast for a difference quotient.
            if (kinds[k].name != "revolute" && kinds[k].name != "weld" && std::fabs(value(0)) < 0.1) continue;
            constexpr double h = 1e-5;
            const double speed = (value(h) - value(-h)) / (2 * h);
            worstSpeed = std::max(worstSpeed, std::fabs(joint.coordinate().speed - speed));
        }
    }
    CHECK(worstValue < 1e-12);  // some ten roundings of 10 m
    CHECK(worstError < 1e-12);
    // h^2 / 6 of a third derivative of up to (speeds of 20 m/s)^3 / (0.1 m)^2, and roundings of 10 m over h
    CHECK(worstSpeed < 1e-5 * 1e-5 / 6 * 8000 / 0.01 + 1e-8);
}

TEST_CASE("a hinge tells by how much it is beyond its limit", "[dynamics][joints]") {
    World world;
    const BodyId base = world.add({.type = BodyType::Static}), arm = world.add(bodyAt({{0, 0}, 0}));
    const JointId hinge =
        world.join(RevoluteJointDef{.bodyA = base, .bodyB = arm, .anchor = {0, 0}, .limit = Limit{-0.25, 0.5}});
    for (const auto& [angle, beyond] : {std::pair{0.4, 0.0}, {0.75, 0.25}, {-0.2, 0.0}, {-1.0, 0.75}}) {
        world.body(arm).setPose({0, 0}, angle);
        CHECK(std::fabs(world.joint(hinge).angleError() - beyond) < 1e-15);
    }
}

TEST_CASE("a gear's coordinate is its joints', and its error is what it has slipped", "[dynamics][joints]") {
    Random random(42);
    for (int i = 0; i < 200; ++i) {
        World world({.gravity = {0, 0}});
        const BodyId base = world.add({.type = BodyType::Static});
        const BodyId a = world.add(bodyAt({{-2, 0}, 0})), b = world.add(bodyAt({{2, 0}, 0}));
        const JointId first = world.join(RevoluteJointDef{.bodyA = base, .bodyB = a, .anchor = {-2, 0}});
        const JointId second = world.join(PrismaticJointDef{.bodyA = base, .bodyB = b, .anchor = {2, 0}});
        const double ratio = random.uniform(-3, 3), turn = random.uniform(-3, 3), shift = random.uniform(-1, 1);
        const JointId gear = world.join(GearJointDef{.jointA = first, .jointB = second, .ratio = ratio});
        world.body(a).setPose({-2, 0}, turn);
        world.body(b).setPose({2 + shift, 0.1}, 0);
        world.body(a).setAngularVelocity(turn);
        world.body(b).setVelocity({shift, 5});
        const JointView view = world.joint(gear);
        CHECK(std::fabs(view.coordinate().value - (turn + ratio * shift)) < 1e-13);
        CHECK(std::fabs(view.coordinate().speed - (turn + ratio * shift)) < 1e-13);
        CHECK(std::fabs(view.error() - std::fabs(turn + ratio * shift)) < 1e-13);
    }
}

TEST_CASE("a pendulum whose bob changes its mass, shapes or centre of mass hangs on the same point, within 1 mm",
          "[dynamics][joints][editing]") {
    const std::vector<std::function<void(World&, BodyId)>> edits{
        [](World& world, BodyId bob) {
            world.body(bob).setMass({50, {0, 0}, 3});
        },
        [](World& world, BodyId bob) {
            world.body(bob).setMass({2, {0.3, -0.2}, 0.5});
        },
        [](World& world, BodyId bob) {
            world.add(bob, {.shape = Circle{.radius = 0.4, .center = {0.8, 0}}});
        },
        [](World& world, BodyId bob) {
            world.shape({bob, 1}).set(box({0.1, 0.9}));
        },
        [](World& world, BodyId bob) {
            world.remove(ShapeId{bob, 0});
        },
        [](World& world, BodyId bob) { world.body(bob).setFixedRotation(true); },
        [](World& world, BodyId bob) {
            world.body(bob).setType(BodyType::Static);
            world.body(bob).setType(BodyType::Dynamic);
        },
        [](World& world, BodyId bob) {
            world.body(bob).setEnabled(false);
            world.step(dt);
            world.body(bob).setEnabled(true);
        },
    };
    for (std::size_t i = 0; i < edits.size(); ++i) {
        INFO("edit " << i);
        World world;
        const BodyId wall = world.add({.type = BodyType::Static}), bob = world.add(bodyAt({{2, 0}, 0}));
        const JointId hinge = world.join(RevoluteJointDef{.bodyA = wall, .bodyB = bob, .anchor = {0.5, 0}});
        const Vec2 local(-1.5, 0);  // the hinge, in the bob's frame
        double worst = 0;
        for (int n = 0; n < 240; ++n) {
            if (n == 20) edits[i](world, bob);
            world.step(dt);
            if (n >= 30) worst = std::max(worst, (world.body(bob).pose() * local - Vec2(0.5, 0)).norm());
        }
        CHECK(worst < 1e-3);
        CHECK(std::fabs(world.joint(hinge).error() - (world.body(bob).pose() * local - Vec2(0.5, 0)).norm()) < 1e-12);
    }
}

TEST_CASE("a chain link made static holds the rest up, made dynamic it falls with it", "[dynamics][joints][editing]") {
    World world;
    const BodyId upper = world.add(bodyAt({{0, 10}, 0})), lower = world.add(bodyAt({{0, 8}, 0}));
    const JointId rod =
        world.join(DistanceJointDef{.bodyA = upper, .bodyB = lower, .anchorA = {0, 10}, .anchorB = {0, 8}});
    world.body(upper).setType(BodyType::Static);
    for (int i = 0; i < 60; ++i) world.step(dt);
    CHECK(std::fabs(world.body(lower).position().y() - 8) < 1e-3);
    const double weight = world.body(lower).mass() * 9.81;
    CHECK(std::fabs(world.joint(rod).reaction().force.norm() - weight) < 1e-3 * weight);
    world.body(lower).setType(BodyType::Static);  // now it can move nothing, and stays a joint
    world.step(dt);
    CHECK(world.contains(rod));
    world.body(upper).setType(BodyType::Dynamic);
    world.body(lower).setType(BodyType::Dynamic);
    world.body(lower).setVelocity({0, 0});
    for (int i = 0; i < 60; ++i) world.step(dt);
    CHECK(std::fabs(world.body(upper).position().y() - (10 - 9.81 / 2)) < 1e-3);
    CHECK(std::fabs((world.body(upper).position() - world.body(lower).position()).norm() - 2) < 1e-3);
}

TEST_CASE("a body that is removed takes its joints and their gear along, and what it held falls as g t^2 / 2",
          "[dynamics][joints][editing]") {
    World world;
    const BodyId wall = world.add({.type = BodyType::Static}), arm = world.add(bodyAt({{0, 5}, 0}));
    const BodyId load = world.add(bodyAt({{5, 5}, 0})), other = world.add(bodyAt({{10, 5}, 0}));
    const JointId hinge = world.join(RevoluteJointDef{.bodyA = wall, .bodyB = other, .anchor = {10, 5}});
    const JointId slide = world.join(PrismaticJointDef{.bodyA = wall, .bodyB = arm, .anchor = {0, 5}});
    const JointId weld = world.join(WeldJointDef{.bodyA = arm, .bodyB = load, .anchor = {5, 5}});
    const JointId gear = world.join(GearJointDef{.jointA = hinge, .jointB = slide});
    for (int i = 0; i < 10; ++i) world.step(dt);
    world.remove(arm);
    for (const JointId gone : {slide, weld, gear}) CHECK_FALSE(world.contains(gone));
    CHECK(world.contains(hinge));
    CHECK(world.body(load).joints().empty());
    CHECK(world.body(other).joints().size() == 1);
    const double from = world.body(load).position().y(), speed = world.body(load).velocityAt({5, 5}).y();
    world.body(load).setVelocity({0, 0});
    world.body(load).setAngularVelocity(0);
    for (int i = 0; i < 60; ++i) world.step(dt);
    CHECK(std::fabs(speed) < 1e-3);
    CHECK(std::fabs(world.body(load).position().y() - (from - 9.81 / 2)) < 1e-5);
}

TEST_CASE("a disabled body's joint does nothing, and holds again when it is enabled", "[dynamics][joints][editing]") {
    World world;
    const BodyId wall = world.add({.type = BodyType::Static, .position = {0, 10}}),
                 bob = world.add(bodyAt({{0, 8}, 0}));
    const JointId rod =
        world.join(DistanceJointDef{.bodyA = wall, .bodyB = bob, .anchorA = {0, 10}, .anchorB = {0, 8}});
    world.body(wall).setEnabled(false);
    for (int i = 0; i < 30; ++i) world.step(dt);
    const double disabled = world.body(bob).position().y();
    world.body(wall).setEnabled(true);
    for (int i = 0; i < 300; ++i) world.step(dt);
    CHECK(disabled <= 8 + 1e-9);
    CHECK(world.joint(rod).error() < 1e-3);
}

TEST_CASE("a motor that is at its limit of 1 N and is given endless force has its speed after the next step",
          "[dynamics][joints][motor]") {
    const auto speedWith = [](auto def, auto force) {
        World world({.gravity = {0, 0}});
        def.bodyA = world.add({.type = BodyType::Static});
        def.bodyB = world.add({.position = {0, 2}, .shapes = {circle(0.5), box({1, 0.2})}});
        def.*force = 1e-3;
        const JointId joint = world.join(def);
        for (int i = 0; i < 5; ++i) world.step(dt);
        def.*force = unlimited;
        world.joint(joint).set(def);
        world.step(dt);
        CHECK_FALSE(world.body(def.bodyB).quarantined());
        return world.joint(joint).coordinate().speed;
    };
    const Vec2 at(0, 2);
    const double hinge = speedWith(RevoluteJointDef{.anchor = at, .motorSpeed = 3}, &RevoluteJointDef::maxMotorTorque);
    const double slide =
        speedWith(PrismaticJointDef{.anchor = at, .motorSpeed = -3}, &PrismaticJointDef::maxMotorForce);
    CHECK(std::fabs(hinge - 3) < 1e-4);  // the solver's give of 1e-5
    CHECK(std::fabs(slide + 3) < 1e-4);
}

TEST_CASE("a motor at its stop that is given endless force stays there, and turned round leaves it at its speed",
          "[dynamics][joints][motor]") {
    World world({.gravity = {0, 0}});
    PrismaticJointDef def{.anchor = {0, 2}, .limit = Limit{-1, 0.5}, .motorSpeed = 3, .maxMotorForce = 50};
    def.bodyA = world.add({.type = BodyType::Static});
    def.bodyB = world.add({.position = {0, 2}, .shapes = {circle(0.5), box({1, 0.2})}});
    const JointId joint = world.join(def);
    for (int i = 0; i < 60; ++i) world.step(dt);
    CHECK(std::fabs(world.joint(joint).coordinate().value - 0.5) < 1e-3);
    def.maxMotorForce = unlimited;
    world.joint(joint).set(def);
    world.step(dt);
    CHECK(std::fabs(world.joint(joint).coordinate().value - 0.5) < 1e-3);
    CHECK_FALSE(world.body(def.bodyB).quarantined());
    def.motorSpeed = -3;
    world.joint(joint).set(def);
    world.step(dt);
    CHECK(std::fabs(world.joint(joint).coordinate().speed + 3) < 1e-3);
}
