// SPDX-License-Identifier: MIT
// What does each phase of a step do to the energy and the momentum of a world?
//
// After each phase all energy there is is summed up anew. What of the change the phase could name by its law, as it
// went, is booked there; the rest under the phase's own entry. An impulse P that changes the speed it acts along from v
// to v' gives P (v + v') / 2, however many act at once: so all impulses of half a sub-step, of contacts and joints, are
// booked by the speeds before the first of them and after the last. Were each booked by the speeds it met, a solver
// that goes round would have friction give energy, and joints take what a blow took.
//
// Tests: "each entry of the ledger is needed for it to close", "friction, blows and dampers never give, in any scene,
// and few joules go without a cause"
#pragma once
#include <array>
#include <vector>

#include <plumb/dynamics/detail/field_store.h>
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

    /// A body that flew through fields has come to its end.
    void noteFieldFlight(const FieldAccount& account);

    // What the solver does, in its order.
    void begin(const WorldState& world);
    /// Before a half sub-step's kick.
    void beforeKick(const WorldState& world, const std::vector<std::uint32_t>& solved);
    /// What fields have given a body after that, of which base was by gravity and by forces [m/s].
    void noteFieldKick(const WorldState& world, std::uint32_t body, const FieldKick& kick, const Vec2& base);
    /// Rows' impulses in one pass, and their speeds after it.
    void noteRows(const JointRows& rows, const Vec3& impulses, const Vec3& after, const Vec3& slopes);
    /// What takes speed out of a row, or gives it, as an impact does.
    void noteImpact(const JointRows& rows, double impulse);
    /// After all impulses of the half.
    void endHalf(const WorldState& world);
    void beforeBounces(const WorldState& world);
    void afterBounces(const WorldState& world);
    /// Bodies of a net, before and after a pass: what their joints to what is fixed have done.
    void noteGround(const Vec2& momentum) { note(&MomentumLedger::ground, momentum); }
    /// After the bodies are stored, of those that were pushed.
    void end(const WorldState& world, const std::vector<std::uint32_t>& solved, double dt);

private:
    struct Lane;
    /// A row's impulses in one pass, by cause.
    struct Given {
        std::array<Vec3, mostEnds> at{};
        std::array<BodyIndex, mostEnds> body{};
        double all = 0, motor = 0, damper = 0, impact = 0;
    };

    struct FieldGiven {
        BodyIndex body = noBody;
        FieldKick kick;
        Vec2 base{0, 0};
    };

    static Given givenBy(const JointRows& rows, std::size_t row, double impulse);
    void noteGiven(const BodyStore& bodies, const Given& given);
    void noteGiven(const BodyStore& bodies, const FieldGiven& given);
    void noteAccount(const FieldAccount& account);
    void noteContact(const Lane& before, const Lane& after, bool hits);

    Ledger ledger_;
    double energy_ = 0, notedEnergy_ = 0;
    Vec2 momentum_{0, 0}, notedMomentum_{0, 0};
    std::vector<SolverVelocity> start_;        ///< velocities before the first impulse of what is going on
    std::vector<Given> given_;                 ///< in this half sub-step
    std::vector<FieldGiven> fieldsGiven_;      ///< likewise
    std::vector<FieldAccount> fieldAccounts_;  ///< of each body, in this step
    std::vector<float> totals_;                ///< normal impulses of the contacts' points, before the bounces
    std::vector<double> dampedEnergy_;         ///< of each body, in this step
    std::vector<Vec2> dampedMomentum_;         ///< likewise
};

}  // namespace plumb
