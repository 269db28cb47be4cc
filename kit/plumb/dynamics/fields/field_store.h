// SPDX-License-Identifier: MIT
// Which fields are there, and what is kept in a step of each body that feels one?
#pragma once
#include <vector>

#include <plumb/dynamics/bodies/free_motion.h>
#include <plumb/dynamics/field.h>
#include <plumb/shapes/aabb.h>

namespace plumb {

using FieldIndex = std::uint32_t;

struct FieldRecord {
    FieldDef def;
    bool alive = false;
    bool filters = false;  ///< its filter is not the one that lets all in
    std::uint32_t generation = 0;
    Aabb box;                          ///< around its region: beyond it the field does not act [m]
    std::vector<BodyIndex> attracted;  ///< within a step, by mutual gravity or a magnet: all that its filter lets in
};

/// What fields do to a velocity and an angular velocity, by cause.
struct FieldKick {
    VelocityChange kept;               ///< by gravity, by forces from outside, and by what has a potential energy
    VelocityChange forced;             ///< by what has none, or ends at a border
    VelocityChange damped;             ///< by drag and damping
    VelocityChange friction;           ///< by friction with the ground
    double rate = 0, turningRate = 0;  ///< of drag and damping at the mean velocity [1/s]
};

/// What fields have done to a body in a step.
struct FieldAccount {
    double forced = 0, damped = 0, friction = 0;                      ///< energy [J]
    Vec2 fields{0, 0}, dampedMomentum{0, 0}, frictionMomentum{0, 0};  ///< [N s]

    /// A kick in which the body's velocity was mean; base is what of it was gravity's and forces' [m/s].
    void add(const BodyRecord& body, const FieldKick& kick, const VelocityChange& mean, const Vec2& base);
    FieldAccount& operator+=(const FieldAccount& other);
};

/// Drag by the square of the speed, per mass.
struct SpeedDrag {
    double rate = 0;  ///< [1/m]
    Vec2 flow{0, 0};  ///< [m/s]
};

/// dv/dt = acceleration - linear v + flow - sum of rate |v - w| (v - w), and friction against v; turning likewise.
struct FieldPull {
    Acceleration acceleration;       ///< all of it
    Acceleration unaccounted;        ///< of that: what has no potential energy
    double linear = 0, turning = 0;  ///< [1/s]
    Vec2 flow{0, 0};                 ///< sum of each linear rate times its flow [m/s^2]
    std::vector<SpeedDrag> quadratic;
    double friction = 0, spinFriction = 0;  ///< [m/s^2, rad/s^2]
};

/// Beside an entry of BodyStore.flights: for the ledger.
struct FlightAccount {
    Vec2 steadyPull{0, 0};  ///< of what is steady: the part that has a potential energy [m/s^2]
    FieldAccount account;   ///< of what is not
};

struct FieldStore {
    std::vector<FieldRecord> records;
    std::vector<FieldIndex> free;

    // Within a step.
    std::vector<FlightAccount> accounts;  ///< parallel to BodyStore.flights
    std::vector<BodyMotion> now;          ///< where bodies are, by slot, for whoever goes through the sub-steps
    std::vector<FieldPull> pulls;         ///< what they feel there

    bool empty() const { return records.size() == free.size(); }
    FieldIndex acquire();
    void release(FieldIndex field);
};

/// What decides where a field acts, and how.
struct FieldView {
    const FieldStore& fields;
    const BodyStore& bodies;
    const Space& space;
};

}  // namespace plumb
