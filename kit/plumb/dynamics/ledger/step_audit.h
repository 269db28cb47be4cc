// SPDX-License-Identifier: MIT
// How does each phase of a step change the energy and the momentum of a world?
//
// After each phase, the whole energy of the world is summed again. The part of the change that has a known cause, such
// as friction, is entered under that cause; the rest is entered under the phase's own entry. An impulse P along a
// direction in which the speed changes from v to v' does the work P (v + v') / 2, however many impulses act at once. So
// all impulses of half a sub-step, of contacts and joints, are entered with the speeds before the first of them and
// after the last. If each were entered with the speeds at its own moment, then, in an iterative solver, friction would
// appear to add energy, and joints would appear to take energy that an impact took.
//
// Tests: "each entry of the ledger is needed for it to close", "friction, blows and dampers never give, in any scene,
// and few joules go without a cause"
#pragma once
#include <array>
#include <vector>

#include <plumb/dynamics/joints/joint_rows.h>
#include <plumb/dynamics/ledger/account.h>

namespace plumb {

/// Enters the changes of a step in an account.
class StepAudit final : public StepObserver {
public:
    StepAudit(Account& account, const LedgerView& view) : account_(account), view_(view), bodies_(view.bodies) {}

    void noteFlight(BodyIndex body, const BodyMotion& from, const BodyMotion& to, double time) override;
    void noteFieldFlight(std::uint32_t flight) override;
    void noteImpact(double friction, double drivers, double bounce, const Vec2& ground) override;
    void beginSolver() override;
    void beginHalf(std::span<const BodyIndex> solved) override;
    void noteFieldKick(BodyIndex body, const FieldKick& kick, const Vec2& base) override;
    void noteRows(const JointRows& rows, const Vec3& impulses, const Vec3& after, const Vec3& slopes) override;
    void noteRowImpact(const JointRows& rows, double impulse) override;
    void noteGround(const Vec2& momentum) override;
    void endHalf() override;
    void beginBounces() override;
    void endBounces() override;
    void endSolver(std::span<const BodyIndex> solved, double dt) override;

private:
    struct Lane;
    /// A row's impulses in one pass, by cause.
    struct Given {
        std::array<Vec3, maxEnds> at{};
        std::array<BodyIndex, maxEnds> body{};
        double all = 0, motor = 0, damper = 0, impact = 0;
    };

    struct FieldGiven {
        BodyIndex body = noBody;
        FieldKick kick;
        Vec2 base{0, 0};
    };

    static Given givenBy(const JointRows& rows, std::size_t row, double impulse);
    void noteGiven(const Given& given);
    void noteGiven(const FieldGiven& given);
    void noteAccount(const FieldAccount& account);
    void noteContact(const Lane& before, const Lane& after, bool hits);
    bool hits(double approach) const;
    bool isAlongChain(const ContactBatch& batch, std::size_t lane) const;

    Account& account_;
    LedgerView view_;
    const BodyStore& bodies_;
    std::vector<SolverVelocity> start_;        ///< velocities before the present half sub-step or the bounces
    std::vector<SolverVelocity> unforced_;     ///< the same, before forces act
    std::vector<Given> given_;                 ///< rows of joints, in this half sub-step
    std::vector<FieldGiven> fieldsGiven_;      ///< kicks of fields, in this half sub-step
    std::vector<FieldAccount> fieldAccounts_;  ///< of each body, in this step
    std::vector<float> totals_;                ///< normal impulses of the contacts' points, before the bounces
    std::vector<double> dampedEnergy_;         ///< of each body, in this step
    std::vector<Vec2> dampedMomentum_;         ///< of each body, in this step
};

}  // namespace plumb
