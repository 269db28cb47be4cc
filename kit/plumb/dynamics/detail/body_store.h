// SPDX-License-Identifier: MIT
// Where is everything about a body kept? The truth in double, one cache line a body; beside it what the solver works
// on.
#pragma once
#include <cstdint>
#include <limits>
#include <vector>

#include <plumb/dynamics/body_def.h>
#include <plumb/dynamics/detail/body_place.h>
#include <plumb/dynamics/detail/solver_body.h>
#include <plumb/dynamics/id.h>
#include <plumb/math/transform.h>
#include <plumb/space/space.h>

namespace plumb {

using BodyIndex = std::uint32_t;
inline constexpr BodyIndex noBody = 0;  ///< slot 0 stands for whatever nothing can move
inline constexpr std::uint32_t none = ~std::uint32_t{0};

/// The truth: where a body is and how it moves.
struct BodyMotion {
    Vec2 center{0, 0};  ///< centre of mass [m]
    Vec2 velocity{0, 0};
    double angle = 0;
    double angularVelocity = 0;
    Rot rotation;  ///< of angle
};

/// Of the body's point that is there now [m/s].
inline Vec2 velocityAt(const BodyMotion& motion, const Vec2& point) {
    return motion.velocity + perp(Vec2(point - motion.center)) * motion.angularVelocity;
}

/// Everything else. What a step asks of every body fills the first two cache lines.
struct alignas(64) BodyRecord {
    BodyType type = BodyType::Static;
    bool alive = false;
    bool awake = false;
    bool canSleep = true;
    bool fixedRotation = false;
    bool quarantined = false;
    bool constrained = false;          ///< the solver has it in this step
    bool flown = false;                ///< the impacts have moved it in this step
    bool boxesWait = false;            ///< it was woken since its boxes were placed
    std::uint32_t solverContacts = 0;  ///< how many contacts of it the solver has
    std::uint32_t actingJoints = 0;    ///< how many of its joints are the solver's
    std::uint32_t flight = none;       ///< in this step: of those that feel fields, which; none when it feels none
    float rho = 1, inverseRho = 1;
    double stillTime = 0;
    double extent = 0;                                      ///< farthest point from the centre of mass [m]
    double reach = 0;                                       ///< and of the cores within what is rounded [m]
    double core = std::numeric_limits<double>::infinity();  ///< radius of a disc that fits into each of its shapes [m]

    double inverseMass = 0, inverseInertia = 0;
    Vec2 force{0, 0};   ///< over the next step [N]
    double torque = 0;  ///< [N m]
    double gravityScale = 1;
    double linearDamping = 0, angularDamping = 0;

    std::uint32_t generation = 0;
    std::uint32_t shapesMade = 0;  ///< the next shape's number
    std::uint32_t awakeIndex = none;
    std::uint32_t firstContact = none;  ///< head of the list of its contacts
    std::uint32_t colours = 0;          ///< bit c: a contact of colour c has it
    std::uint32_t doubtful = 0;         ///< how many of the solver's contacts may yet turn out to be isolated impacts
    double mass = 0, inertia = 0;
    Vec2 localCenter{0, 0};
    bool enabled = true;
    bool massGiven = false;  ///< not what its shapes and their densities give
    std::uint64_t tag = 0;
    std::vector<ProxyId> proxies;       ///< in the order of their numbers
    std::vector<std::uint32_t> joints;  ///< all of its joints
};

/// Parallel arrays, indexed by a body's slot; slot 0 is nobody's.
struct BodyStore {
    std::vector<BodyMotion> motion;
    std::vector<BodyRecord> record;
    std::vector<BodyPlace> place;
    std::vector<SolverVelocity> velocity;
    std::vector<SolverDisplacement> displacement;
    std::vector<SolverVelocity> warm;    ///< what the contacts' impulses, all together, do to the velocity
    std::vector<SolverVelocity> before;  ///< the velocity before the contacts were solved
    std::vector<SolverTurn> turn;
    std::vector<Kick> kick;
    std::vector<std::uint8_t> pushed;  ///< 1: a constraint gave it an impulse in this step
    std::vector<BodyIndex> awake;      ///< dynamic and kinematic bodies that are
    std::vector<BodyIndex> kinematic;  ///< all that are
    std::vector<BodyIndex> forced;     ///< with a force or torque for the next step; some may be named twice
    std::vector<BodyIndex> free;
    Wrap wrap;  ///< of the world; a body that goes round it counts on

    BodyStore();
    void reserve(std::size_t bodies);
    BodyIndex acquire();
    void release(BodyIndex body);
    void wake(BodyIndex body);
    void putToSleep(BodyIndex body);
    /// Tells the hot loops where a body is that does not move.
    void rest(BodyIndex body);

    bool isDynamic(BodyIndex body) const { return record[body].type == BodyType::Dynamic; }
    /// Can something push it?
    bool canMove(BodyIndex body) const { return isDynamic(body) && record[body].enabled; }
    /// The place of all those a whole round apart that is as near to another as can be.
    Vec2 near(const Vec2& point, const Vec2& other) const {
        return wrap.any() ? Vec2(point + wrap.shiftNear(point, other)) : point;
    }
    Vec2 origin(BodyIndex body) const { return motion[body].center - motion[body].rotation * record[body].localCenter; }
    /// The centre of mass was there all along: also where the last step began.
    void recenterPlace(BodyIndex body, const Vec2& shift);
    Transform pose(BodyIndex body) const { return {origin(body), motion[body].rotation}; }
    SolverBodies solverBodies() {
        return {velocity.data(), warm.data(), before.data(), displacement.data(), turn.data(), kick.data()};
    }
};

/// Where a body is and how it is turned, in the floats of the hot loops; all else zero.
BodyPlace placeOf(const BodyMotion& motion, float rho);

/// Acceleration of a body's centre and its angle over this step [m/s^2, rad/s^2].
struct Acceleration {
    Vec2 linear{0, 0};
    double angular = 0;
};
Acceleration accelerationOf(const BodyRecord& body, const Vec2& gravity);

/// Sets mass, inertia and all that follows from them.
void setMass(BodyRecord& body, const Mass& mass);
/// What the solver takes for a body's inertia; until setMass, or joints, say something else.
void setRho(BodyRecord& body, double inverseInertia);

}  // namespace plumb
