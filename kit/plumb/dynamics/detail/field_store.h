// SPDX-License-Identifier: MIT
// Which fields are there, and what is kept of each body that they act on?
#pragma once
#include <vector>

#include <plumb/dynamics/detail/body_store.h>
#include <plumb/dynamics/field.h>

namespace plumb {

using FieldIndex = std::uint32_t;

struct FieldRecord {
    FieldDef def;
    bool alive = false;
    bool choosy = false;  ///< its filter is not the one that lets all in
    std::uint32_t generation = 0;
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
};

/// How a body will fly through the step, unless something touches it.
struct FieldFlight {
    Acceleration mean;  ///< beyond gravity and forces: with it, the closed form comes to where it will be
    double rate = 0, turningRate = 0;  ///< of drag and damping together, as they are in the mean [1/s]
    Push rest;                         ///< what its velocity will be beyond what that says
    FieldAccount account;
};

struct FieldStore {
    std::vector<FieldRecord> records;
    std::vector<FieldIndex> free;
    std::vector<FieldFlight> flights;  ///< by body, within a step; none where there are no fields

    bool empty() const { return records.size() == free.size(); }
    FieldIndex acquire();
    void release(FieldIndex field);
};

}  // namespace plumb
