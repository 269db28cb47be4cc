// SPDX-License-Identifier: MIT
// Which fields does the world have, and which data is kept in a step for each body on which one acts?
#pragma once
#include <vector>

#include <plumb/dynamics/bodies/free_motion.h>
#include <plumb/dynamics/field_def.h>
#include <plumb/math/detail/owned.h>
#include <plumb/math/detail/step_list.h>
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

/// A predicted flight, and the energy and momentum that fields give during it.
struct FieldFlight {
    PredictedFlight flight;
    FieldAccount account;
};

struct FieldStore;
struct FieldStores;
class StepObserver;

/// What do fields do in a step? Each world has a field solver: at first one of this class, which does nothing; the
/// world's first field puts a FieldSolving in its place (field_solving.h). So the linker leaves all code of fields out
/// of a program without fields.
class FieldSolver {
public:
    virtual ~FieldSolver() = default;
    virtual std::unique_ptr<FieldSolver> copy() const { return std::make_unique<FieldSolver>(); }

    /// Before a step: notes which bodies a field attracts, and returns those that may not sleep.
    virtual StepList<BodyIndex> gatherAttracted(FieldStore&, FieldIndex, const BodyStore&, const Space&) { return {}; }
    /// At the start of a step of dt [s]: predicts the flights of all bodies on which fields act.
    virtual void predictFlights(FieldStore&, BodyStore&, const Space&, double) {}
    /// Predicts how a body on which fields act moves on for a time [s]. It is at from, at a time start [s] after the
    /// step's start.
    virtual FieldFlight flightFrom(FieldStore&, const BodyStore&, const Space&, const PredictedFlight&,
                                   const BodyMotion&, double, double) {
        return {};
    }

    /// Before the sub-steps of h [s]; observer: may be null.
    virtual void begin(FieldStore&, BodyStore&, const Space&, double, StepObserver*) {}
    /// In each half of a sub-step, after the bodies' kick and before the joints, at the positions and velocities that
    /// the bodies have at that moment: changes the velocities of those solved bodies on which fields act. The list may
    /// be filled up with noBody.
    virtual void kick(std::span<const BodyIndex>) {}
    /// After the bodies have moved by a sub-step.
    virtual void moved() {}

    virtual StepList<BodyIndex> influencedBy(const FieldStores&, const FieldRecord&) const { return {}; }
    virtual double energy(const FieldStores&) const { return 0; }  ///< of all bodies [J]
    /// Of one body if it were there [J].
    virtual double energyOf(const FieldStores&, BodyIndex, const BodyMotion&) const { return 0; }
};

struct FieldStore {
    Owned<FieldSolver> solver;
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
