// SPDX-License-Identifier: MIT
// Which fields are there, and what is kept in a step of each body that feels one?
#pragma once
#include <vector>

#include <plumb/dynamics/detail/free_motion.h>
#include <plumb/dynamics/field.h>
#include <plumb/shapes/aabb.h>

namespace plumb {

using FieldIndex = std::uint32_t;

struct FieldRecord {
    FieldDef def;
    bool alive = false;
    bool choosy = false;  ///< its filter is not the one that lets all in
    std::uint32_t generation = 0;
    Aabb box;                      ///< around its region: beyond it the field does not act [m]
    std::vector<BodyIndex> drawn;  ///< within a step, by mutual gravity or a magnet: all that its filter lets in
};

/// What a field does to a velocity and a spin.
struct Push {
    Vec2 velocity{0, 0};  ///< [m/s]
    double spin = 0;      ///< [rad/s]
    Push& operator+=(const Push& other) {
        velocity += other.velocity;
        spin += other.spin;
        return *this;
    }
};

/// The same by cause, for the ledger.
struct FieldKick {
    Push kept;                         ///< by gravity, by forces from outside, and by what has a potential energy
    Push forced;                       ///< by what has none, or ends at a border
    Push damped;                       ///< by drag and damping
    Push rubbed;                       ///< by friction with the ground
    double rate = 0, turningRate = 0;  ///< of drag and damping at the mean velocity [1/s]
};

/// What fields have done to a body in a step.
struct FieldAccount {
    double forced = 0, damped = 0, rubbed = 0;                      ///< energy [J]
    Vec2 fields{0, 0}, dampedMomentum{0, 0}, rubbedMomentum{0, 0};  ///< [N s]

    /// A kick in which the body's velocity was mean; base is what of it was gravity's and forces' [m/s].
    void add(const BodyRecord& body, const FieldKick& kick, const Push& mean, const Vec2& base);
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

/// How a body that feels fields will fly through the step, or what is left of it, unless something touches it.
struct FieldFlight {
    BodyIndex body = noBody;
    bool steady = false;    ///< what acts on it is the same wherever it is: its law is exact, and nothing is left over
    Vec2 steadyPull{0, 0};  ///< of that, what has a potential energy [m/s^2]
    FlightLaw law;          ///< a closed form that comes to where it will be
    Push rest;              ///< what its velocity will be beyond what that says
    FieldAccount account;   ///< of what is not steady
};

struct FieldStore {
    std::vector<FieldRecord> records;
    std::vector<FieldIndex> free;

    // Within a step.
    std::vector<FieldFlight> flights;  ///< BodyRecord.flight says which is whose
    std::vector<BodyMotion> now;       ///< where bodies are, by slot, for whoever goes through the sub-steps
    std::vector<FieldPull> pulls;      ///< what they feel there

    bool empty() const { return records.size() == free.size(); }
    FieldIndex acquire();
    void release(FieldIndex field);
};

}  // namespace plumb
