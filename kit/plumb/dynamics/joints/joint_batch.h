// SPDX-License-Identifier: MIT
// How do the bodies of joint islands get into the solver's lanes, and back?
//
// A batch holds up to eight islands of one layout in double, from the start of a step to its end. All others see the
// bodies' records, in float. What they change there is the difference between a record and the rounded number of the
// batch; it is added to the batch's number. So a number that nobody else changes is never rounded.
#pragma once
#include <span>

#include <plumb/dynamics/bodies/step_observer.h>
#include <plumb/dynamics/joints/joint_store.h>
#include <plumb/dynamics/joints/lanes/island_kernel.h>
#include <plumb/dynamics/joints/lanes/island_layout.h>

namespace plumb {

struct JointIsland;

/// How a body has moved in a step, and its velocity at the step's end.
struct BodyMove {
    Vec2 shift{0, 0};     ///< [m]
    double turn = 0;      ///< [rad]
    Vec2 velocity{0, 0};  ///< [m/s]
    double spin = 0;      ///< [rad/s]
};

class JointBatch {
public:
    JointBatch() = default;
    /// A copy is empty: it is filled at the start of a step.
    JointBatch(const JointBatch&) {}
    JointBatch(JointBatch&&) = default;
    JointBatch& operator=(const JointBatch&) { return *this = JointBatch(); }
    JointBatch& operator=(JointBatch&&) = default;

    /// Takes in islands of one layout, as they are at the start of a step with sub-steps of h [s].
    void load(std::span<JointIsland* const> islands, const JointStore& joints, BodyStore& bodies, double h);
    /// Writes states and loads of the joints, stiffness of the islands and moments of inertia, at the end of the step.
    void store(JointStore& joints, BodyStore& bodies);
    /// At the end of the step.
    BodyMove moveOf(std::size_t lane, std::size_t node) const;

    /// Adds what others have changed.
    void pull(const BodyStore& bodies);
    /// Of one island; moved: bodies have been moved, too. The other islands stay as they are: what is added in two
    /// parts is rounded otherwise than what is added at once, and bits must not depend on who shares a batch.
    void pull(const BodyStore& bodies, std::size_t lane, bool moved);
    /// Others may have moved bodies: the next pull takes that in.
    void noteMoves() { moved_ = true; }
    /// Lets the step's forces and the contacts' first guess act.
    void kick(BodyStore& bodies, bool first);
    void writeVelocities(BodyStore& bodies) const;
    void move(BodyStore& bodies, double h);
    void noteSpeeds() { kernel_->noteSpeeds(view_); }

    /// One pass over all joints; onlyHold: in the lanes where active is true.
    void solve(BodyStore& bodies, const IslandTurn& turn, StepObserver* observer);
    void hold(BodyStore& bodies, double h, double fastest, std::span<const bool> active, StepObserver* observer);

    /// Of a joint that is swept: its bodies have other joints, too, which are in other batches. give: compliance of
    /// rows that hold, in addition [-].
    void sweep(BodyStore& bodies, const IslandTurn& turn, double give, StepObserver* observer);

    // For one island:
    /// By how much the worst joint of one island has opened since the step's start [m].
    double opening(std::size_t lane) const;
    /// Applies an impulse (x, y, turning) to a body, and those of the joints that follow from it.
    void push(BodyStore& bodies, std::size_t lane, std::size_t node, const Vec3& impulse);
    /// By how much that would change the body's velocity.
    Vec3 answer(std::size_t lane, std::size_t node, const Vec3& impulse);

    // For an island that is alone in its batch (see solver/machine_contacts.h):
    /// Solves from velocities without the joints' impulses, with rows predicted from the present velocities. Returns
    /// true if a row came to another part of its curve.
    bool tryFrom(BodyStore& bodies, std::span<const Vec3> before, const IslandTurn& turn);
    void acceptTry(StepObserver* observer);
    /// Adds to changes of velocity those by the joints' impulses that follow from them.
    void follow(std::span<Vec3> changes);
    /// The change of velocity of a body by an impulse, without the joints'.
    Vec3 changeBy(std::size_t lane, std::size_t node, const Vec3& impulse) const;

    const std::vector<JointIsland*>& islands() const { return islands_; }
    std::size_t bytes() const { return bytesOf(numbers_) + bytesOf(islands_); }

private:
    double& number(double* items, std::size_t count, std::size_t item, int field, std::size_t lane) const {
        return items[(item * count + static_cast<std::size_t>(field)) * width_ + lane];
    }
    double& body(std::size_t node, int field, std::size_t lane) const {
        return number(view_.body, BodyField::count, node, field, lane);
    }
    double& row(std::size_t i, int field, std::size_t lane) const {
        return number(view_.row, RowField::count, i, field, lane);
    }
    void layOut(bool isNew);
    void loadBody(const BodyStore& bodies, BodyIndex index, std::size_t node, std::size_t lane, double h);
    void loadJoint(const JointForm& form, const JointStore& joints, JointIndex index, const BodyStore& bodies,
                   std::size_t j, std::size_t lane, double h);
    void loadRow(const RowForm& form, const Rot& rotationA, double springShare, std::size_t i, std::size_t lane,
                 double h);
    /// Returns true if a place has changed.
    bool pullLane(const BodyStore& bodies, std::size_t lane, bool moved);
    double errorOf(std::size_t row, std::size_t lane) const;
    void writePlaces(BodyStore& bodies) const;
    void noteStates();
    void activate(bool all, std::size_t lane);
    bool activateFast(double h);
    void report(StepObserver& observer) const;
    JointRows rowsOf(std::size_t j, std::size_t lane, Vec3& impulses, Vec3& after, Vec3& slopes) const;

    std::vector<JointIsland*> islands_;
    std::shared_ptr<const IslandLayout> layout_;
    const IslandKernel* kernel_ = nullptr;
    std::size_t width_ = 1;
    double h_ = 0;  ///< of the sub-step [s]
    IslandLanes view_;
    std::vector<double> numbers_;
    std::array<double, 8> active_{};
    bool moved_ = false;  ///< others may have moved bodies
};

}  // namespace plumb
