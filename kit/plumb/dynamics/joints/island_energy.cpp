// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/island_energy.h>

#include <algorithm>
#include <cmath>

namespace plumb {

namespace {

/// The motion of a rigid body, about a point.
struct RigidMotion {
    Vec2 center{0, 0}, velocity{0, 0};
    double spin = 0;

    Vec2 velocityAt(const Vec2& place) const { return velocity + spin * perp(place - center); }
};

struct Node {
    Vec2 place{0, 0}, velocity{0, 0};
    double spin = 0, mass = 0, inertia = 0;

    /// Of its motion relative to another one.
    double energyBeside(const RigidMotion& rigid) const {
        const double turning = spin - rigid.spin;
        return 0.5 * mass * (velocity - rigid.velocityAt(place)).squaredNorm() + 0.5 * inertia * turning * turning;
    }
};

enum class Masses { Own, Solved };

/// Calls visit(number, node) for each body that impulses move. Where the world wraps, each is taken beside the one
/// before it: a machine may lie across a seam.
template <class Visit>
void forEachNode(const IslandNumbers& numbers, const BodyStore& bodies, std::size_t lane, Masses masses,
                 Visit&& visit) {
    Vec2 center = bodies.motion[numbers.movedBody(0, lane)].center;
    for (std::size_t n = 0; n < numbers.layout->moved; ++n) {
        const auto at = [&](int field) { return numbers.body(n, field, lane); };
        const bool own = masses == Masses::Own;
        center = bodies.near(bodies.motion[numbers.movedBody(n, lane)].center, center);
        visit(n, Node{center + Vec2(at(BodyField::X), at(BodyField::Y)), Vec2(at(BodyField::Vx), at(BodyField::Vy)),
                      at(BodyField::Spin), at(own ? BodyField::OwnMass : BodyField::Mass),
                      at(own ? BodyField::OwnInertia : BodyField::Inertia)});
    }
}

/// Of an island that nothing holds; of another one, that of the first body which holds it.
RigidMotion rigidMotionOf(const IslandNumbers& numbers, const BodyStore& bodies, std::size_t lane, Masses masses) {
    const JointIsland& island = *numbers.islands[lane];
    if (!island.held.empty()) {
        const BodyMotion& held = bodies.motion[island.held.front()];
        const Vec2 first = bodies.motion[numbers.movedBody(0, lane)].center;
        return {bodies.near(held.center, first), held.velocity, held.angularVelocity};
    }
    RigidMotion rigid;
    double mass = 0, inertia = 0;
    forEachNode(numbers, bodies, lane, masses, [&](std::size_t, const Node& node) {
        mass += node.mass;
        rigid.center += node.mass * node.place;
        rigid.velocity += node.mass * node.velocity;
    });
    rigid.center /= mass;
    rigid.velocity /= mass;
    forEachNode(numbers, bodies, lane, masses, [&](std::size_t, const Node& node) {
        const Vec2 arm = node.place - rigid.center;
        rigid.spin += node.mass * cross(arm, node.velocity) + node.inertia * node.spin;
        inertia += node.mass * arm.squaredNorm() + node.inertia;
    });
    rigid.spin = inertia > 0 ? rigid.spin / inertia : 0;
    return rigid;
}

double energyBeside(const RigidMotion& rigid, const IslandNumbers& numbers, const BodyStore& bodies, std::size_t lane,
                    Masses masses) {
    double energy = 0;
    forEachNode(numbers, bodies, lane, masses,
                [&](std::size_t, const Node& node) { energy += node.energyBeside(rigid); });
    return energy;
}

}  // namespace

double fallOf(const IslandNumbers& numbers, std::size_t lane, int velocity) {
    double fall = 0;
    for (std::size_t n = 0; n < numbers.layout->moved; ++n) {
        const auto at = [&](int field) { return numbers.body(n, field, lane); };
        fall +=
            at(BodyField::OwnMass) * (at(BodyField::GainX) * at(velocity) + at(BodyField::GainY) * at(velocity + 1));
    }
    return fall;
}

double energyOf(const IslandNumbers& numbers, const BodyStore& bodies, std::size_t lane) {
    return energyBeside(rigidMotionOf(numbers, bodies, lane, Masses::Own), numbers, bodies, lane, Masses::Own);
}

double takeEnergy(const IslandNumbers& numbers, const BodyStore& bodies, std::size_t lane, double energy) {
    const RigidMotion rigid = rigidMotionOf(numbers, bodies, lane, Masses::Solved);
    const double own = energyBeside(rigid, numbers, bodies, lane, Masses::Solved);
    const double kept = own > energy ? std::sqrt(1 - energy / own) : 0.0;
    forEachNode(numbers, bodies, lane, Masses::Solved, [&](std::size_t n, const Node& node) {
        const Vec2 base = rigid.velocityAt(node.place), velocity = base + kept * (node.velocity - base);
        numbers.body(n, BodyField::Vx, lane) = velocity.x();
        numbers.body(n, BodyField::Vy, lane) = velocity.y();
        numbers.body(n, BodyField::Spin, lane) = rigid.spin + kept * (node.spin - rigid.spin);
    });
    return std::min(own, energy);
}

}  // namespace plumb
