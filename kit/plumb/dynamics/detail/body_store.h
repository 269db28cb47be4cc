// SPDX-License-Identifier: MIT
// Where is everything about a body kept? The truth in double, one cache line a body; beside it what the solver works
// on.
#pragma once
#include <cstdint>
#include <vector>

#include <plumb/dynamics/body_def.h>
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

/// What the solver reads and writes of a body's velocity: 16 bytes, mass included. Turning is scaled by the radius of
/// gyration's inverse, so that one inverse mass serves both:
///   rho^2 = (1/I) / (1/m), w = omega / rho, and an impulse P at r changes v by P/m and w by (rho r x P)/m.
struct SolverVelocity {
    float x = 0, y = 0;  ///< [m/s]
    float w = 0;         ///< omega / rho [m/s]
    float inverseMass = 0;
};

/// How far a body has come in this step; rotation as s/rho and (c - 1)/rho of the angle turned.
struct SolverDisplacement {
    float x = 0, y = 0;
    float sin = 0, cosMinus1 = 0;
};

/// What half a sub-step of gravity, forces and damping does to a velocity: v * keep + gain.
struct Kick {
    float gainX = 0, gainY = 0, gainW = 0;
    float keep = 1, keepW = 1;
};

/// Everything else.
struct BodyRecord {
    BodyType type = BodyType::Static;
    bool alive = false;
    bool awake = false;
    bool canSleep = true;
    bool fixedRotation = false;
    bool quarantined = false;
    bool constrained = false;  ///< the solver has it in this step
    bool pushed = false;       ///< a constraint gave it an impulse in this step
    bool flown = false;        ///< the impacts have moved it in this step
    std::uint32_t generation = 0;
    double mass = 0, inertia = 0, inverseMass = 0, inverseInertia = 0;
    float rho = 1, inverseRho = 1;
    Vec2 localCenter{0, 0};
    double extent = 0;  ///< farthest point from the centre of mass [m]
    double gravityScale = 1, linearDamping = 0, angularDamping = 0;
    Vec2 force{0, 0};   ///< over the next step [N]
    double torque = 0;  ///< [N m]
    double stillTime = 0;
    std::vector<ProxyId> proxies;
    std::vector<std::uint32_t> joints;
    std::uint32_t firstContact = none;  ///< head of the list of its contacts
    std::uint32_t awakeIndex = none;
    std::uint32_t colours = 0;  ///< bit c: a contact of colour c has it
};

/// Parallel arrays, indexed by a body's slot; slot 0 is nobody's.
struct BodyStore {
    std::vector<BodyMotion> motion;
    std::vector<BodyRecord> record;
    std::vector<SolverVelocity> velocity;
    std::vector<SolverDisplacement> displacement;
    std::vector<SolverVelocity> warm;    ///< what the contacts' impulses, all together, do to the velocity
    std::vector<SolverVelocity> before;  ///< the velocity before the contacts were solved
    std::vector<float> turn;             ///< angle turned in this step [rad]
    std::vector<Kick> kick;
    std::vector<BodyIndex> awake;  ///< dynamic and kinematic bodies that are
    std::vector<BodyIndex> free;

    BodyStore();
    BodyIndex acquire();
    void release(BodyIndex body);
    void wake(BodyIndex body);
    void putToSleep(BodyIndex body);

    bool isDynamic(BodyIndex body) const { return record[body].type == BodyType::Dynamic; }
    /// The solver's record: its own where it moves, the common fixed one where it does not.
    BodyIndex solverIndex(BodyIndex body) const { return record[body].awake ? body : noBody; }
    Vec2 origin(BodyIndex body) const { return motion[body].center - motion[body].rotation * record[body].localCenter; }
    Transform pose(BodyIndex body) const { return {origin(body), motion[body].rotation}; }
};

/// Acceleration of a body's centre and its angle over this step [m/s^2, rad/s^2].
struct Acceleration {
    Vec2 linear{0, 0};
    double angular = 0;
};
Acceleration accelerationOf(const BodyRecord& body, const Vec2& gravity);

/// Sets mass, inertia and all that follows from them.
void setMass(BodyRecord& body, const Mass& mass);

}  // namespace plumb
