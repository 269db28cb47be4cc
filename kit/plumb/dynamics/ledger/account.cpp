// SPDX-License-Identifier: MIT
#include <plumb/dynamics/ledger/account.h>

#include <cmath>

namespace plumb {

/// m v^2 / 2 + I w^2 / 2. A body of fixed rotation keeps its inertia in its record, but nothing turns it:
/// inverseInertia tells.
double kineticEnergyOf(const BodyRecord& body, const Vec2& velocity, double spin) {
    return 0.5 * body.mass * velocity.squaredNorm() +
           (body.inverseInertia > 0 ? 0.5 * body.inertia * spin * spin : 0.0);
}

/// -m s g.x, zero at the world's origin; in a world that wraps, coordinates keep counting, so it has no jump at the
/// seam.
double gravitationalEnergyOf(const BodyRecord& body, const Vec2& center, const Vec2& gravity) {
    return -body.mass * body.gravityScale * gravity.dot(center);
}

void Account::note(Energy entry, double energy) {
    if (!std::isfinite(energy)) return;  // of a body that goes into quarantine
    ledger_.energy.*entry += energy;
    notedEnergy_ += energy;
}

void Account::note(Momentum entry, const Vec2& momentum) {
    if (!momentum.allFinite()) return;
    ledger_.momentum.*entry += momentum;
    notedMomentum_ += momentum;
}

/// Sums the whole world anew, so nothing can be forgotten: what the notes of the phase do not explain goes to the given
/// entries. So after each call, and up to rounding,
///   stored = stored at the last call + all notes since + the rest
/// O(bodies + joints) for each phase, in worlds with a ledger only.
/// Test: "each entry of the ledger is needed for it to close"
void Account::close(const LedgerView& view, Energy energy, Momentum momentum) {
    EnergyLedger& e = ledger_.energy;
    const BodyStore& bodies = view.bodies;
    e.kinetic = e.gravitational = e.spring = 0;
    e.fields = view.fields.solver->energy({view.fields, bodies, view.space});
    Vec2 sum(0, 0);
    for (BodyIndex body = 1; body < bodies.record.size(); ++body) {
        const BodyRecord& record = bodies.record[body];
        if (!record.alive || record.type != BodyType::Dynamic) continue;
        const BodyMotion& motion = bodies.motion[body];
        if (!isInRange(motion)) continue;  // it goes into quarantine before it can act on anything
        e.kinetic += kineticEnergyOf(record, motion.velocity, motion.angularVelocity);
        e.gravitational += gravitationalEnergyOf(record, motion.center, bodies.gravity);
        sum += record.mass * motion.velocity;
    }
    e.spring = view.jointSolver.springEnergy(view.joints, bodies);
    e.*energy += (e.stored() - energy_) - notedEnergy_;
    ledger_.momentum.*momentum += (sum - momentum_) - notedMomentum_;
    ledger_.momentum.momentum = momentum_ = sum;
    energy_ = e.stored();
    notedEnergy_ = 0;
    notedMomentum_.setZero();
}

}  // namespace plumb
