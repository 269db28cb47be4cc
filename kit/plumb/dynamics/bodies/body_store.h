// SPDX-License-Identifier: MIT
// Where is the data of bodies stored? The state is in double precision, one cache line per body; beside it are the
// floats that the solver uses.
#pragma once
#include <cstdint>
#include <limits>
#include <vector>

#include <plumb/collide/lanes/body_place.h>
#include <plumb/dynamics/bodies/flight_law.h>
#include <plumb/dynamics/bodies/solver_body.h>
#include <plumb/dynamics/body_def.h>
#include <plumb/dynamics/id.h>
#include <plumb/math/detail/arrays.h>
#include <plumb/math/transform.h>
#include <plumb/space/detail/space.h>

namespace plumb {

/// The state of a body: where it is and how it moves.
struct BodyMotion {
    Vec2 center{0, 0};  ///< centre of mass [m]
    Vec2 velocity{0, 0};
    double angle = 0;
    double angularVelocity = 0;
    Rot rotation;  ///< cosine and sine of angle
};

/// The velocity of the body's material point that is now at this point [m/s].
inline Vec2 velocityAt(const BodyMotion& motion, const Vec2& point) {
    return motion.velocity + perp(Vec2(point - motion.center)) * motion.angularVelocity;
}

/// Along x, along y, turning.
inline Vec3 velocityOf(const BodyMotion& motion) {
    return {motion.velocity.x(), motion.velocity.y(), motion.angularVelocity};
}
inline void setVelocity(BodyMotion& motion, const Vec3& velocity) {
    motion.velocity = {velocity[0], velocity[1]};
    motion.angularVelocity = velocity[2];
}

/// The periodic image of a body at this offset [m].
inline BodyMotion shifted(const BodyMotion& motion, const Vec2& shift) {
    BodyMotion image = motion;
    image.center += shift;
    return image;
}
inline Transform shifted(const Transform& pose, const Vec2& shift) {
    return {pose.position + shift, pose.rotation};
}

/// A body may have passed something on its way if it has moved by more than this share of its inradius in a step [-].
inline constexpr double farShare = 0.5;

/// A body that turns by more than this in a step spins: what is predicted from its pose at the step's start may be far
/// from where it meets others [rad].
inline constexpr double spinningTurn = 0.25;

/// A body's properties, and the forces that act on it. The fields that every step reads of every body come first: they
/// fill two cache lines.
struct alignas(64) BodyRecord {
    BodyType type = BodyType::Static;
    bool alive = false;
    bool awake = false;
    bool canSleep = true;
    bool fixedRotation = false;
    bool quarantined = false;
    bool enabled = true;
    bool massGiven = false;  ///< the mass was set directly, not computed from shapes and densities
    float inverseGyration = 1, gyration = 1;
    double stillTime = 0;
    double boundingRadius = 0;  ///< distance of the farthest point from the centre of mass [m]
    double turningRadius = 0;   ///< the same without rounding radii, see turningRadiusOf [m]
    double inradius =
        std::numeric_limits<double>::infinity();  ///< radius of a disc that fits into each of its shapes [m]

    double inverseMass = 0, inverseInertia = 0;
    Vec2 force{0, 0};   ///< acts during the next step [N]
    double torque = 0;  ///< acts during the next step [N m]
    double gravityScale = 1;
    double linearDamping = 0, angularDamping = 0;
    Vec2 localCenter{0, 0};

    std::uint32_t generation = 0;
    std::uint32_t shapesMade = 0;  ///< the number that the next shape gets
    std::uint32_t awakeIndex = none;
    double mass = 0, inertia = 0;
    std::uint64_t tag = 0;
};

/// The contacts, shapes and joints of a body. One cache line.
struct alignas(64) BodyLinks {
    std::uint32_t firstContact = none;  ///< head of the list of its contacts
    std::uint32_t colours = 0;          ///< bit c is set if one of its contacts has colour c
    std::uint32_t solverContacts = 0;   ///< number of its contacts that are in the solver
    std::uint32_t actingJoints = 0;     ///< number of its joints that are in the solver
    std::vector<ProxyId> proxies;       ///< its shapes, in the order of their numbers
    std::vector<std::uint32_t> joints;  ///< all of its joints
};

/// Which part of the step moves a body?
enum class MovedBy : std::uint8_t {
    Nothing,     ///< none: the body is static, asleep or in quarantine
    ClosedForm,  ///< the closed form of free motion
    Impacts,     ///< the phase that solves isolated impacts one by one
    Chain,       ///< the closed form of a slide along a chain; the solver finds only its contacts' impulses
    Solver,      ///< the solver: contacts or joints gave the body an impulse
};

/// Data of a body that is valid during a step.
struct BodyStep {
    MovedBy movedBy = MovedBy::Nothing;
    bool boundsPending = false;   ///< the body woke up after the step had placed the bounds
    bool placed = false;          ///< it is in BodyStore.placed
    std::uint32_t flight = none;  ///< entry in BodyStore.flights; none if no field acts on the body
};

/// What is noted of a slow body, to find whether it gains speed (see islands/stillness.h).
struct StillWatch {
    Vec2 center{0, 0};                                       ///< where the part of the watch began [m]
    double angle = 0;                                        ///< there [rad]
    double time = 0;                                         ///< since then [s]
    double least = std::numeric_limits<double>::infinity();  ///< lowest mean speed of a part [m/s]
    double gained = 0;           ///< highest mean speed after a rise that it has not lost again; 0: none [m/s]
    BodyIndex blocker = noBody;  ///< a restless body of its island, when that was searched last
    double blockedUntil = 0;     ///< after this time at rest, the island is searched again [s]
};

/// Parallel arrays, indexed by a body's slot. Slot 0 belongs to no body (see noBody).
struct BodyStore {
    // Each body's state, properties and links.
    std::vector<BodyMotion> motion;
    std::vector<BodyRecord> record;
    std::vector<BodyLinks> links;
    std::vector<std::vector<BodyIndex>> apart;  ///< bodies with which its joints forbid contacts; may hold duplicates

    std::vector<StillWatch> watch;  ///< valid while record.stillTime > 0

    // Within a step.
    std::vector<BodyStep> step;
    std::vector<BodyPlace> place;
    std::vector<SolverVelocity> velocity;
    std::vector<SolverDisplacement> displacement;
    std::vector<SolverVelocity> warm;    ///< velocity change by all warm-start impulses of the body's contacts
    std::vector<SolverVelocity> before;  ///< the velocity before the contacts were solved
    std::vector<SolverTurn> turn;
    std::vector<Kick> kick;
    std::vector<PredictedFlight> flights;  ///< one for each body on which fields act
    std::vector<BodyIndex> outOfRange;     ///< bodies that must go into quarantine

    // Lists of slots.
    std::vector<BodyIndex> awake;      ///< awake bodies, dynamic and kinematic
    std::vector<BodyIndex> kinematic;  ///< all kinematic bodies
    std::vector<BodyIndex> placed;     ///< bodies that jumped, or got shapes, since the last step; may hold duplicates
    std::vector<BodyIndex> forced;     ///< bodies with a force or torque for the next step; may hold duplicates
    std::vector<BodyIndex> free;       ///< slots without a body

    bool someSpin = false;  ///< at the step's start, some body turns by more than spinningTurn

    // What all bodies of a world have in common.
    Wrap wrap;                ///< periods of the world; positions of bodies are not reduced to the first period
    Vec2 gravity{0, -9.81};   ///< [m/s^2]
    int subSteps = 4;         ///< number of the solver's sub-steps in a step [-]
    double lastStep = 0;      ///< dt of the last step with dt > 0; during a step, its own dt [s]
    double lastSolved = 0;    ///< dt of the last step in which contacts were solved [s]
    double stepRatio = 1;     ///< of lastSolved to the one before it [-]
    std::uint32_t world = 0;  ///< number of the world, as stored in ids

    BodyStore();
    void reserve(std::size_t bodies);
    BodyIndex acquire();
    void release(BodyIndex body);
    void wake(BodyIndex body);
    void notePlaced(BodyIndex body);
    void putToSleep(BodyIndex body);
    /// Sets the data that the narrow phase and the solver read, for a body that does not move.
    void rest(BodyIndex body);

    BodyId idOf(BodyIndex body) const { return {body, record[body].generation, world}; }
    bool isDynamic(BodyIndex body) const { return record[body].type == BodyType::Dynamic; }
    /// Can an impulse move the body?
    bool canMove(BodyIndex body) const { return isDynamic(body) && record[body].enabled; }
    /// Does the body have contacts or joints in the solver in this step?
    bool isConstrained(BodyIndex body) const {
        return isDynamic(body) && (links[body].solverContacts > 0 || links[body].actingJoints > 0);
    }
    bool isMovedBy(BodyIndex body, MovedBy mover) const { return step[body].movedBy == mover; }
    /// Do joints forbid contacts between two bodies?
    bool areKeptApart(BodyIndex a, BodyIndex b) const;
    /// The periodic image of a point that is nearest to another point.
    Vec2 near(const Vec2& point, const Vec2& other) const {
        return wrap.any() ? Vec2(point + wrap.shiftNear(point, other)) : point;
    }
    Vec2 origin(BodyIndex body) const { return motion[body].center - motion[body].rotation * record[body].localCenter; }
    /// Moves the stored place at the start of the last step, too, after the centre of mass has changed by shift in the
    /// body's frame [m].
    void recenterPlace(BodyIndex body, const Vec2& shift);
    Transform pose(BodyIndex body) const { return {origin(body), motion[body].rotation}; }
    SolverBodies solverBodies() {
        return {velocity.data(), warm.data(), before.data(), displacement.data(), turn.data(), kick.data()};
    }
};

/// Are all numbers finite, and below 1e15 m and m/s? Then their squares still fit into the solver's floats.
bool isInRange(const BodyMotion& motion);
bool isInRange(const Acceleration& acceleration);
/// Sets the state of a body. If the new state is out of range, the body keeps the old one and is marked for quarantine.
void storeMotion(BodyStore& bodies, BodyIndex body, const BodyMotion& motion);
/// Forgets which bodies were placed, at the end of a step.
void clearPlaced(BodyStore& bodies);
/// Sets all forces and torques to zero, at the end of a step.
void clearForces(BodyStore& bodies);
/// Marks a body for quarantine.
void markOutOfRange(BodyStore& bodies, BodyIndex body);

inline ShapeId idOfShape(const BodyStore& bodies, const Proxy& proxy) {
    return {bodies.idOf(proxy.owner), proxy.number};
}

/// A body's position and rotation in floats, for the narrow phase and the solver; all other fields are zero.
BodyPlace placeOf(const BodyMotion& motion, float inverseGyration);

/// The acceleration by gravity, and by the force and torque of this step.
Acceleration accelerationOf(const BodyRecord& body, const Vec2& gravity);

/// Sets mass, centre of mass, inertia and all values that follow from them.
void setMass(BodyRecord& body, const Mass& mass);
/// Sets the inertia that the solver uses for a body, until setMass or a stiff joint sets another.
void setGyration(BodyRecord& body, double inverseInertia);

}  // namespace plumb
