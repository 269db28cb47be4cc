// SPDX-License-Identifier: MIT
// What does each phase of a step do to the energy and the momentum of a world?
//
// After each phase all energy there is is summed up anew. What of the change the phase could name by its law, as it
// went, is booked there; the rest under the phase's own entry. An impulse P that changes the speed it acts along from v
// to v' gives P (v + v') / 2, however many act at once: so impulses are booked by the speeds before and after all of
// them. Test: "each entry of the ledger is needed for it to close"
#pragma once
#include <vector>

#include <plumb/dynamics/detail/contact_batch.h>
#include <plumb/dynamics/detail/contact_solver.h>
#include <plumb/dynamics/detail/joint_rows.h>
#include <plumb/dynamics/ledger.h>

namespace plumb {

struct WorldState;
struct BodyMotion;

class Audit {
public:
    using Energy = double EnergyLedger::*;
    using Momentum = Vec2 MomentumLedger::*;

    const Ledger& ledger() const { return ledger_; }

    /// Part of what the phase now going on does.
    void note(Energy entry, double energy);
    void note(Momentum entry, const Vec2& momentum);
    /// A phase is over: what it did beyond that.
    void book(const WorldState& world, Energy energy, Momentum momentum);

    /// A body that nothing pushed, or that was flown by the impacts, has gone from one place to another in a time.
    void noteFlight(const WorldState& world, std::uint32_t body, const BodyMotion& from, const BodyMotion& to,
                    double time);

    // What the solver does, in its order.
    void begin(const WorldState& world);
    /// Before a half sub-step's kick; after it, what the contacts' first guess has done.
    void beforeKick(const WorldState& world, const std::vector<std::uint32_t>& solved);
    void afterKick(const WorldState& world);
    /// Lane by lane, with the scalar solver: the same bits.
    void solveContacts(WorldState& world,
                       void (*solve)(ContactBatch*, std::size_t, const SolverBodies&, const ContactPass&),
                       std::size_t colour, const ContactPass& pass);
    void bounceContacts(WorldState& world, std::size_t colour);
    /// Rows' impulses in one pass, and their speeds before and after it.
    void noteRows(const BodyStore& bodies, const JointRows& rows, const Vec3& impulses, const Vec3& before,
                  const Vec3& after, const Vec3& slopes);
    /// Bodies of a net, before and after a pass: what their joints to what is fixed have done.
    void noteGround(const Vec2& momentum) { note(&MomentumLedger::ground, momentum); }
    /// After the bodies are stored, of those that were pushed.
    void end(const WorldState& world, const std::vector<std::uint32_t>& solved, double dt);

private:
    struct Lane;

    void noteContact(const Lane& before, const Lane& after, bool hits);
    bool hits(const WorldState& world, std::size_t colour, std::size_t batch, std::size_t lane) const;

    Ledger ledger_;
    double energy_ = 0, notedEnergy_ = 0;
    Vec2 momentum_{0, 0}, notedMomentum_{0, 0};
    std::vector<SolverVelocity> unwarmed_;  ///< velocities as they would be without the contacts' first guess
    std::vector<double> dampedEnergy_;      ///< of each body, in this step
    std::vector<Vec2> dampedMomentum_;      ///< likewise
};

}  // namespace plumb
