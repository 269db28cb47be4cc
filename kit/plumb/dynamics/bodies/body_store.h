// SPDX-License-Identifier: MIT
// Where is everything about a body kept? Its state in double, one cache line a body; beside it what the solver works
// on.
#pragma once
#include <cstdint>
#include <limits>
#include <vector>

#include <plumb/dynamics/bodies/flight_law.h>
#include <plumb/dynamics/bodies/solver_body.h>
#include <plumb/dynamics/body_def.h>
#include <plumb/dynamics/id.h>
#include <plumb/math/transform.h>
#include <plumb/space/space.h>

namespace plumb {

/// The state of a body: where it is and how it moves.
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

/// A body's periodic image, that far from it.
inline BodyMotion shifted(const BodyMotion& motion, const Vec2& shift) {
    BodyMotion image = motion;
    image.center += shift;
    return image;
}
inline Transform shifted(const Transform& pose, const Vec2& shift) {
    return {pose.position + shift, pose.rotation};
}

/// Properties, and what acts on the body. What every step reads of every body fills the first two cache lines.
struct alignas(64) BodyRecord {
    BodyType type = BodyType::Static;
    bool alive = false;
    bool awake = false;
    bool canSleep = true;
    bool fixedRotation = false;
    bool quarantined = false;
    bool enabled = true;
    bool massGiven = false;  ///< not what its shapes and their densities give
    float inverseGyration = 1, gyration = 1;
    double stillTime = 0;
    double boundingRadius = 0;  ///< farthest point from the centre of mass [m]
    double turningRadius = 0;   ///< and of the cores within what is rounded [m]
    double inradius =
        std::numeric_limits<double>::infinity();  ///< radius of a disc that fits into each of its shapes [m]

    double inverseMass = 0, inverseInertia = 0;
    Vec2 force{0, 0};   ///< over the next step [N]
    double torque = 0;  ///< [N m]
    double gravityScale = 1;
    double linearDamping = 0, angularDamping = 0;

    std::uint32_t generation = 0;
    std::uint32_t shapesMade = 0;  ///< the next shape's number
    std::uint32_t awakeIndex = none;
    double mass = 0, inertia = 0;
    Vec2 localCenter{0, 0};
    std::uint64_t tag = 0;
};

/// What a body is connected with. One cache line.
struct alignas(64) BodyLinks {
    std::uint32_t firstContact = none;  ///< head of the list of its contacts
    std::uint32_t colours = 0;          ///< bit c: a contact of colour c has it
    std::uint32_t solverContacts = 0;   ///< how many of its contacts the solver has
    std::uint32_t actingJoints = 0;     ///< how many of its joints the solver has
    std::vector<ProxyId> proxies;       ///< in the order of their numbers
    std::vector<std::uint32_t> joints;  ///< all of its joints
};

/// Who moves a body in this step?
enum class MovedBy : std::uint8_t {
    Nothing,     ///< it is at rest: static, asleep or taken out
    ClosedForm,  ///< it moves as if nothing touched it
    Impacts,     ///< its isolated impacts were solved one by one
    Solver,      ///< contacts or joints gave it an impulse
};

/// What is known of a body within a step.
struct BodyStep {
    MovedBy movedBy = MovedBy::Nothing;
    bool boundsPending = false;   ///< it was woken since its bounds were placed
    std::uint32_t flight = none;  ///< entry of BodyStore.flights; none when it feels no field
};

/// Parallel arrays, indexed by a body's slot; slot 0 is nobody's.
struct BodyStore {
    // Each body's state, properties and links.
    std::vector<BodyMotion> motion;
    std::vector<BodyRecord> record;
    std::vector<BodyLinks> links;
    std::vector<std::vector<BodyIndex>> apart;  ///< bodies that its joints keep it from touching; some are named twice

    // Within a step.
    std::vector<BodyStep> step;
    std::vector<BodyPlace> place;
    std::vector<SolverVelocity> velocity;
    std::vector<SolverDisplacement> displacement;
    std::vector<SolverVelocity> warm;    ///< what the contacts' impulses, all together, do to the velocity
    std::vector<SolverVelocity> before;  ///< the velocity before the contacts were solved
    std::vector<SolverTurn> turn;
    std::vector<Kick> kick;
    std::vector<PredictedFlight> flights;  ///< of the bodies that feel fields
    std::vector<BodyIndex> outOfRange;     ///< to be put in quarantine

    // Lists of slots.
    std::vector<BodyIndex> awake;      ///< dynamic and kinematic bodies that are
    std::vector<BodyIndex> kinematic;  ///< all that are
    std::vector<BodyIndex> forced;     ///< with a force or torque for the next step; some may be named twice
    std::vector<BodyIndex> free;

    // What all bodies of a world have in common.
    Wrap wrap;                ///< a body that goes round the world counts on
    Vec2 gravity{0, -9.81};   ///< [m/s^2]
    int subSteps = 4;         ///< of the solver
    double lastStep = 0;      ///< dt of the last step that took time; within a step, its own [s]
    std::uint32_t world = 0;  ///< as ids have it

    BodyStore();
    void reserve(std::size_t bodies);
    BodyIndex acquire();
    void release(BodyIndex body);
    void wake(BodyIndex body);
    void putToSleep(BodyIndex body);
    /// Tells the hot loops where a body is that does not move.
    void rest(BodyIndex body);

    BodyId idOf(BodyIndex body) const { return {body, record[body].generation, world}; }
    bool isDynamic(BodyIndex body) const { return record[body].type == BodyType::Dynamic; }
    /// Can something push it?
    bool canMove(BodyIndex body) const { return isDynamic(body) && record[body].enabled; }
    /// Does the solver have it in this step?
    bool isConstrained(BodyIndex body) const {
        return isDynamic(body) && (links[body].solverContacts > 0 || links[body].actingJoints > 0);
    }
    bool isMovedBy(BodyIndex body, MovedBy mover) const { return step[body].movedBy == mover; }
    /// Do joints keep two bodies from touching each other?
    bool areKeptApart(BodyIndex a, BodyIndex b) const;
    /// Of a point's periodic images, the one nearest to another point.
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

/// Finite, and below 1e15 m and m/s, so that squares still fit the solver's floats.
bool isInRange(const BodyMotion& motion);
bool isInRange(const Acceleration& acceleration);
/// Gives a body a new place and speed; one out of range stays where it is, marked for quarantine.
void moveTo(BodyStore& bodies, BodyIndex body, const BodyMotion& motion);
/// At the end of a step: what acted over it acts no more.
void clearForces(BodyStore& bodies);
/// Marks a body for quarantine.
void markOutOfRange(BodyStore& bodies, BodyIndex body);

inline ShapeId idOfShape(const BodyStore& bodies, const Proxy& proxy) {
    return {bodies.idOf(proxy.owner), proxy.number};
}

/// Where a body is and how it is turned, in the floats of the hot loops; all else zero.
BodyPlace placeOf(const BodyMotion& motion, float inverseGyration);

/// Of gravity and of the forces of this step.
Acceleration accelerationOf(const BodyRecord& body, const Vec2& gravity);

/// Sets mass, inertia and all that follows from them.
void setMass(BodyRecord& body, const Mass& mass);
/// What the solver takes for a body's inertia; until setMass, or joints, say something else.
void setGyration(BodyRecord& body, double inverseInertia);

}  // namespace plumb
