// SPDX-License-Identifier: MIT
// Which events of a step does an observer receive, such as the ledger of energy and momentum?
#pragma once
#include <span>

#include <plumb/dynamics/bodies/body_store.h>
#include <plumb/math/detail/arrays.h>

namespace plumb {

struct FieldKick;
struct JointRows;

/// The interface of such an observer. It only reads: a step has the same result with and without one.
class StepObserver {
public:
    virtual ~StepObserver() = default;

    /// A body in free motion, or between two impacts, has moved from one state to another in a time [s].
    virtual void noteFlight(BodyIndex body, const BodyMotion& from, const BodyMotion& to, double time) = 0;
    /// A body on which fields act has reached the end of its free motion; flight: its entry in BodyStore.flights.
    virtual void noteFieldFlight(std::uint32_t flight) = 0;
    /// An impact: the energy from friction, from bodies that impulses do not move (drivers), and from the impulses
    /// along the normal (bounce) [J], and the momentum from such bodies (ground) [N s].
    virtual void noteImpact(double friction, double drivers, double bounce, const Vec2& ground) = 0;

    // The solver's events, in the order in which they happen.
    virtual void beginSolver() = 0;
    /// Called before the forces of half a sub-step act.
    virtual void beginHalf(std::span<const BodyIndex> solved) = 0;
    /// After beginHalf: the velocity change of a body by fields; base: its part by gravity and forces [m/s].
    virtual void noteFieldKick(BodyIndex body, const FieldKick& kick, const Vec2& base) = 0;
    /// A joint's rows in one pass: their impulses, their speeds after the pass, and slopes: by how much each impulse
    /// falls per unit of speed.
    virtual void noteRows(const JointRows& rows, const Vec3& impulses, const Vec3& after, const Vec3& slopes) = 0;
    /// An impulse along a joint's row that changes its speed as an impact does.
    virtual void noteRowImpact(const JointRows& rows, double impulse) = 0;
    /// The momentum that joints to fixed bodies have given [N s].
    virtual void noteGround(const Vec2& momentum) = 0;
    virtual void endHalf() = 0;
    virtual void beginBounces() = 0;
    virtual void endBounces() = 0;
    /// Called after the solver has stored the bodies' new states.
    virtual void endSolver(std::span<const BodyIndex> solved, double dt) = 0;
};

}  // namespace plumb
