// SPDX-License-Identifier: MIT
#include <plumb/dynamics/walls/wall_limits.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/bodies/load_bodies.h>

namespace plumb {

namespace {

/// Walls are looked for as far as a body comes at this many times its speed [-]. A body that is pushed in the step may
/// gain speed; up to this factor, its limit stays true, and its path need not be searched in each sub-step. With more,
/// a larger box meets walls more often, and fewer limits can be raised.
constexpr double spareRoom = 2;

class WallLimits {
public:
    WallLimits(BodyStore& bodies, const ContactStore& contacts, const Space& space, double dt)
        : bodies_(bodies), view_{bodies, contacts, space}, dt_(dt) {}

    /// One query of the space for each fast body, once a step, in place of a search in each sub-step. Bodies without
    /// contacts need none: mayPass leaves them out. Not in a world that wraps.
    void raise() {
        if (bodies_.wrap.any()) return;
        for (const BodyIndex body : bodies_.awake) {
            float& limit = bodies_.turn[body].farSpeedSquared;
            const float speed = speedSquared(bodies_.velocity[body]);
            if (!(speed > limit) || bodies_.links[body].firstContact == none) continue;
            const double reached = spareRoom * std::sqrt(static_cast<double>(speed));
            if (isFarFromWalls(body, reached * dt_)) limit = static_cast<float>(reached * reached);
        }
    }

    /// A spring that pulls a body slowly into a wall would pull it through in many steps: where the body is deep
    /// already, each of its paths is searched. Not what other bodies press in: a chain under a heavy box jumps when it
    /// is stopped there (tried).
    void lowerWhereDeep(const ContactGraph& graph, const JointStore& joints, std::span<const JointIsland> islands) {
        for (const JointIsland& island : islands)
            for (const std::uint32_t j : island.sprung)
                for (const BodyIndex body : {joints[island.joints[j]].bodyA, joints[island.joints[j]].bodyB})
                    if (isDeep(graph, body)) bodies_.turn[body].farSpeedSquared = -1;
    }

    /// What matters is the motion relative to a wall, so a wall that moves takes its part of the distance that a body
    /// may move unseen. Only contacts are asked: bounds hold the predicted paths of both, so what a wall may reach has
    /// one.
    void lowerBesideMoving() {
        for (const BodyIndex wall : bodies_.kinematic) {
            if (isAtRest(wall)) continue;
            forEachContact(bodies_, view_.contacts, wall, [&](ContactIndex index) {
                const BodyIndex body = otherOf(view_.contacts[index], wall);
                if (bodies_.isDynamic(body)) lower(body, wallTravel(wall, body, view_.contacts[index]));
            });
        }
    }

private:
    bool isDeep(const ContactGraph& graph, BodyIndex body) const {
        double separation = 0;
        if (!bodies_.isDynamic(body) || !bodies_.record[body].awake) return false;
        forEachContact(bodies_, view_.contacts, body, [&](ContactIndex index) {
            if (!view_.contacts[index].isSolved() || !isOfGround(view_.contacts[index].colour)) return;
            const ConstContactLane at = graph.laneOf(view_.contacts[index]);
            for (const PointLanes& point : at.batch.points)
                separation = std::min(separation, static_cast<double>(point.separation[at.lane]));
        });
        return -separation > deepIn(bodies_.record[body].inradius);
    }

    bool isFarFromWalls(BodyIndex body, double distance) const {
        const Vec2& center = bodies_.motion[body].center;
        const Aabb box = inflate({center, center}, bodies_.record[body].boundingRadius + distance);
        bool far = true;
        view_.space.queryFixed(box, [&far](ProxyId, const Vec2&) { far = false; });
        if (far) forEachKinematicNear(view_, box, [&far](ProxyId, const Vec2&) { far = false; });
        return far;
    }

    bool isAtRest(BodyIndex wall) const {
        const BodyMotion& motion = bodies_.motion[wall];
        return motion.velocity.isZero(0) && motion.angularVelocity == 0;
    }

    /// An upper bound on how far a moving wall moves by the outline of a body that is at rest, in the step [m]. The
    /// wall's motion is taken at the body's centre; seen from the wall, the body turns the other way round by as much.
    double wallTravel(BodyIndex wall, BodyIndex body, const ContactRecord& contact) const {
        const Vec2 image = contact.bodyA == wall ? Vec2(-contact.shift) : contact.shift;
        const BodyMotion there = shifted(bodies_.motion[wall], image);
        const Vec2 shift = velocityAt(there, bodies_.motion[body].center) * dt_;
        return travelOf(shift, there.angularVelocity * dt_, bodies_.record[body]);
    }

    /// The body may move by farShare of its inradius less the wall's travel: its limit of speed falls in proportion,
    /// and the limit is squared. If nothing is left, the limit is -1, and the body is always searched.
    void lower(BodyIndex body, double travel) {
        const BodyRecord& record = bodies_.record[body];
        const double left = std::max(1 - travel / (farShare * record.inradius), 0.0);
        const float limit = left > 0 ? farSpeedSquared(record, dt_) * static_cast<float>(left * left) : -1;
        bodies_.turn[body].farSpeedSquared = std::min(bodies_.turn[body].farSpeedSquared, limit);
    }

    BodyStore& bodies_;
    WallView view_;
    double dt_;
};

}  // namespace

void limitByWalls(const WallLimitStores& stores, double dt) {
    WallLimits limits(stores.bodies, stores.contacts, stores.space, dt);
    limits.raise();
    limits.lowerBesideMoving();
    limits.lowerWhereDeep(stores.graph, stores.joints, stores.jointSolver.islands());
}

}  // namespace plumb
