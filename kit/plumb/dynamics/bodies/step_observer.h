// SPDX-License-Identifier: MIT
// What is whoever keeps account of a step told while it goes on?
#pragma once
#include <vector>

#include <plumb/dynamics/bodies/body_store.h>
#include <plumb/math/detail/mat3.h>

namespace plumb {

struct FieldKick;
struct JointRows;

/// The ledger is one. Nothing that it is told changes what a step does.
class StepObserver {
public:
    virtual ~StepObserver() = default;

    /// A body that nothing pushed, or that impacts moved, has gone from one place to another in a time.
    virtual void noteFlight(BodyIndex body, const BodyMotion& from, const BodyMotion& to, double time) = 0;
    /// A body that fields have guided has come to the end of its flight, an entry of BodyStore.flights.
    virtual void noteFieldFlight(std::uint32_t flight) = 0;
    /// What friction and what is not pushed have given in an impact [J], and what the ground has [N s].
    virtual void noteImpact(double friction, double drivers, const Vec2& ground) = 0;

    // What the solver does, in its order.
    virtual void beginSolver() = 0;
    /// Before the forces of half a sub-step act.
    virtual void beginHalf(const std::vector<BodyIndex>& solved) = 0;
    /// What fields have given a body after that, of which base was by gravity and by forces [m/s].
    virtual void noteFieldKick(BodyIndex body, const FieldKick& kick, const Vec2& base) = 0;
    /// Impulses of a joint's rows in one pass, their speeds after it, and how they fall with those.
    virtual void noteRows(const JointRows& rows, const Vec3& impulses, const Vec3& after, const Vec3& slopes) = 0;
    /// What takes speed out of a row, or gives it, as an impact does.
    virtual void noteRowImpact(const JointRows& rows, double impulse) = 0;
    /// What joints to what is fixed have given [N s].
    virtual void noteGround(const Vec2& momentum) = 0;
    virtual void endHalf() = 0;
    virtual void beginBounces() = 0;
    virtual void endBounces() = 0;
    /// After the bodies are stored.
    virtual void endSolver(const std::vector<BodyIndex>& solved, double dt) = 0;
};

}  // namespace plumb
