// SPDX-License-Identifier: MIT
// Which fields does the world have, and which data is kept in a step for each body on which one acts?
#pragma once
#include <vector>

#include <plumb/dynamics/bodies/free_motion.h>
#include <plumb/dynamics/field_def.h>
#include <plumb/shapes/aabb.h>

namespace plumb {

using FieldIndex = std::uint32_t;

struct FieldRecord {
    FieldDef def;
    bool alive = false;
    bool filters = false;  ///< its filter does not let in every body
    std::uint32_t generation = 0;
    Aabb box;                          ///< around its region: outside of it the field does not act [m]
    std::vector<BodyIndex> attracted;  ///< within a step: bodies that mutual gravity or a magnet may attract
};

/// The changes of a body's velocity and angular velocity by fields, by cause.
struct FieldKick {
    VelocityChange kept;               ///< by gravity, applied forces, and fields with a potential energy
    VelocityChange forced;             ///< by fields without a potential energy, or with a region
    VelocityChange damped;             ///< by drag and damping
    VelocityChange friction;           ///< by friction with the ground
    double rate = 0, turningRate = 0;  ///< of drag and damping at the mean velocity [1/s]
};

/// The energy and momentum that fields have given a body in a step.
struct FieldAccount {
    double forced = 0, damped = 0, friction = 0;                      ///< energy [J]
    Vec2 fields{0, 0}, dampedMomentum{0, 0}, frictionMomentum{0, 0};  ///< [N s]

    /// Adds a kick during which the body's mean velocity was mean. base: the part of the kick by gravity and applied
    /// forces [m/s].
    void add(const BodyRecord& body, const FieldKick& kick, const VelocityChange& mean, const Vec2& base);
    FieldAccount& operator+=(const FieldAccount& other);
};

/// Drag in proportion to the square of the speed, per mass.
struct SpeedDrag {
    double rate = 0;  ///< [1/m]
    Vec2 flow{0, 0};  ///< [m/s]
};

/// dv/dt = acceleration - linear v + flow - sum of rate |v - w| (v - w), and friction against v. Turning has the same
/// form.
struct FieldPull {
    Acceleration acceleration;       ///< by all fields
    Acceleration unaccounted;        ///< the part of it by fields without a potential energy
    double linear = 0, turning = 0;  ///< [1/s]
    Vec2 flow{0, 0};                 ///< sum of each linear rate times its flow [m/s^2]
    std::vector<SpeedDrag> quadratic;
    double friction = 0, spinFriction = 0;  ///< [m/s^2, rad/s^2]
};

/// The ledger's data for an entry of BodyStore.flights.
struct FlightAccount {
    Vec2 steadyPull{0, 0};  ///< acceleration by steady fields that have a potential energy [m/s^2]
    FieldAccount account;   ///< of varying fields
};

struct FieldPhases;

struct FieldStore {
    const FieldPhases* phases = nullptr;  ///< null before the first field
    std::vector<FieldRecord> records;
    std::vector<FieldIndex> free;

    // Within a step.
    std::vector<FlightAccount> accounts;  ///< parallel to BodyStore.flights
    std::vector<BodyMotion> now;          ///< motions of the bodies, by slot, at the present sub-step
    std::vector<FieldPull> pulls;         ///< the pulls of the fields on them there

    bool empty() const { return records.size() == free.size(); }
    FieldIndex acquire();
    void release(FieldIndex field);
};

/// The stores that decide where a field acts, and how.
struct FieldStores {
    const FieldStore& fields;
    const BodyStore& bodies;
    const Space& space;
};

}  // namespace plumb
