// SPDX-License-Identifier: MIT
// How much energy and momentum does a world have, and what has changed them?
#pragma once
#include <plumb/dynamics/contacts/contact_graph.h>
#include <plumb/dynamics/fields/field_store.h>
#include <plumb/dynamics/jointed/joint_solver.h>
#include <plumb/dynamics/ledger.h>

namespace plumb {

/// The stores that the account reads.
struct LedgerView {
    const BodyStore& bodies;
    const FieldStore& fields;
    const ContactGraph& graph;
    const JointStore& joints;
    const Space& space;
    const JointSolver& jointSolver;
};

double kineticEnergyOf(const BodyRecord& body, const Vec2& velocity, double spin);              ///< [J]
double gravitationalEnergyOf(const BodyRecord& body, const Vec2& center, const Vec2& gravity);  ///< [J]

class Account {
public:
    using Energy = double EnergyLedger::*;
    using Momentum = Vec2 MomentumLedger::*;

    const Ledger& ledger() const { return ledger_; }

    /// Enters a part of the change that the current phase makes.
    void note(Energy entry, double energy);
    void note(Momentum entry, const Vec2& momentum);
    /// Ends a phase: the change that was not noted goes to these entries.
    void close(const LedgerView& view, Energy energy, Momentum momentum);

private:
    Ledger ledger_;
    double energy_ = 0, notedEnergy_ = 0;
    Vec2 momentum_{0, 0}, notedMomentum_{0, 0};
};

}  // namespace plumb
