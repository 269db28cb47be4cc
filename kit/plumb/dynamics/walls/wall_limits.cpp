// SPDX-License-Identifier: MIT
#include <plumb/dynamics/walls/wall_limits.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/bodies/load_bodies.h>

namespace plumb {

namespace {

/// Walls are looked for as far as a body comes at this many times its speed.
constexpr double spareRoom = 2;

class WallLimits {
public:
    WallLimits(BodyStore& bodies, const ContactStore& contacts, const Space& space, double dt)
        : bodies_(bodies), view_{bodies, contacts, space}, dt_(dt) {}

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

    /// An upper bound on how far a moving wall moves by the outline of a body that is at rest, in the step [m].
    double wallTravel(BodyIndex wall, BodyIndex body, const ContactRecord& contact) const {
        const Vec2 image = contact.bodyA == wall ? Vec2(-contact.shift) : contact.shift;
        const BodyMotion there = shifted(bodies_.motion[wall], image);
        const Vec2 shift = velocityAt(there, bodies_.motion[body].center) * dt_;
        return travelOf(shift, there.angularVelocity * dt_, bodies_.record[body]);
    }

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

void limitByWalls(BodyStore& bodies, const ContactStore& contacts, const Space& space, double dt) {
    WallLimits limits(bodies, contacts, space, dt);
    limits.raise();
    limits.lowerBesideMoving();
}

}  // namespace plumb
