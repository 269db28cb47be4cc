// SPDX-License-Identifier: MIT
#include "kit/dynamics/falls_machines.h"

#include <algorithm>

namespace plumb::test {

namespace {

struct Builder {
    World& world;
    Vec2 origin, velocity;
    Rot turned;
    double spin = 0;
    ThrownMachine made{};

    Vec2 placeOf(const Vec2& local) const { return origin + turned * local; }

    BodyId add(const Vec2& at, double angle, ShapeDef shape) {
        const Vec2 place = placeOf(at);
        made.bodies.push_back(world.add({.position = place,
                                         .angle = std::atan2(turned.sin, turned.cos) + angle,
                                         .velocity = velocity + perp(Vec2(place - origin)) * spin,
                                         .angularVelocity = spin,
                                         .shapes = {std::move(shape)}}));
        return made.bodies.back();
    }
    void hinge(BodyId a, BodyId b, const Vec2& at) {
        made.joints.push_back(world.join(RevoluteJointDef{.bodyA = a, .bodyB = b, .anchor = placeOf(at)}));
    }
    void hinge(BodyId a, BodyId b, const Vec2& at, double least, double most) {
        made.joints.push_back(
            world.join(RevoluteJointDef{.bodyA = a, .bodyB = b, .anchor = placeOf(at), .limit = Limit{least, most}}));
    }
};

constexpr Material skin{.friction = 0.6};

void addPair(Builder& to) {
    const BodyId left = to.add({-0.5, 0}, 0, box({0.5, 0.15}, skin)),
                 right = to.add({0.5, 0}, 0, box({0.5, 0.15}, skin));
    to.hinge(left, right, {0, 0});
}

void addCar(Builder& to) {
    const BodyId hull = to.add({0, 0}, 0, box({0.9, 0.25}, skin));
    for (const double x : {-0.6, 0.6}) to.hinge(hull, to.add({x, -0.35}, 0, circle(0.3, skin)), {x, -0.35});
}

void addDoll(Builder& to) {
    const BodyId chest = to.add({0, 0}, 0, box({0.18, 0.3}, skin)), head = to.add({0, 0.47}, 0, circle(0.15, skin));
    to.hinge(chest, head, {0, 0.32}, -0.5, 0.5);
    for (const double side : {-1.0, 1.0}) {
        const BodyId arm = to.add({side * 0.4, 0.22}, 0, capsule({-0.17, 0}, {0.17, 0}, 0.06, skin));
        to.hinge(chest, arm, {side * 0.2, 0.22}, -1.5, 1.5);
        const BodyId thigh = to.add({side * 0.1, -0.5}, 0, capsule({0, -0.15}, {0, 0.15}, 0.08, skin));
        to.hinge(chest, thigh, {side * 0.1, -0.32}, -1, 1);
        const BodyId shin = to.add({side * 0.1, -0.88}, 0, capsule({0, -0.15}, {0, 0.15}, 0.07, skin));
        to.hinge(thigh, shin, {side * 0.1, -0.69}, -1, 1);
    }
}

void addRope(Builder& to) {
    BodyId before = to.add({0, 0}, 0, capsule({-0.1, 0}, {0.1, 0}, 0.05, skin));
    for (int i = 1; i < 12; ++i) {
        const BodyId link = to.add({0.25 * i, 0}, 0, capsule({-0.1, 0}, {0.1, 0}, 0.05, skin));
        to.hinge(before, link, {0.25 * i - 0.125, 0});
        before = link;
    }
}

}  // namespace

double ThrownMachine::widestGap(const World& world) const {
    double widest = 0;
    for (const JointId joint : joints) widest = std::max(widest, world.joint(joint).error());
    return widest;
}

ThrownMachine addMachine(World& world, MachineKind kind, Random& random, const Vec2& at, const Vec2& velocity) {
    Builder builder{world, at, velocity, Rot::fromAngle(random.uniform(-3, 3)), random.uniform(-8, 8)};
    switch (kind) {
        case MachineKind::Pair: addPair(builder); break;
        case MachineKind::Car: addCar(builder); break;
        case MachineKind::Doll: addDoll(builder); break;
        case MachineKind::Rope: addRope(builder); break;
    }
    return builder.made;
}

}  // namespace plumb::test
