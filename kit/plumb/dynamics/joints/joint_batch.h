// SPDX-License-Identifier: MIT
// How do the bodies of joint islands get into the solver's lanes, and back?
//
// A batch holds up to eight islands of one layout in double, from the start of a step to its end. All others see the
// bodies' records, in float. What they change there is the difference between a record and the rounded number of the
// batch; it is added to the batch's number. So a number that nobody else changes is never rounded.
#pragma once
#include <span>

#include <plumb/dynamics/bodies/step_observer.h>
#include <plumb/dynamics/joints/joint_island.h>
#include <plumb/dynamics/joints/joint_store.h>
#include <plumb/dynamics/joints/lanes/island_kernel.h>
#include <plumb/dynamics/joints/lanes/island_layout.h>

namespace plumb {

/// How a body has moved in a step, and its velocity at the step's end.
struct BodyMove {
    Vec2 shift{0, 0};     ///< [m]
    double turn = 0;      ///< [rad]
    Vec2 velocity{0, 0};  ///< [m/s]
    double spin = 0;      ///< [rad/s]
};

/// With which mass and inertia contacts see a body.
struct ContactBody {
    BodyIndex body = noBody;
    double mass = 0;     ///< [kg]
    double inertia = 0;  ///< 0: it cannot turn [kg m^2]
};

class JointBatch {
public:
    using Lanes = std::array<double, 8>;  ///< of each lane: 1 or 0

    JointBatch() = default;
    /// A copy is empty: it is filled at the start of a step.
    JointBatch(const JointBatch&) {}
    JointBatch(JointBatch&&) = default;
    JointBatch& operator=(const JointBatch&) { return *this = JointBatch(); }
    JointBatch& operator=(JointBatch&&) = default;

    /// Takes in islands of one layout, as they are at the start of a step with sub-steps of h [s].
    void load(std::span<JointIsland* const> islands, const JointStore& joints, BodyStore& bodies, double h);
    /// After solve: adds the bodies that contacts shall see as heavier than they are, because joints hold them to
    /// heavier ones, if this has changed since the last call. first: in this step.
    void findContactBodies(const BodyStore& bodies, bool first, std::vector<ContactBody>& found);
    /// The same, after noteBearing, for the islands that have changed.
    void findChangedBodies(const BodyStore& bodies, std::vector<ContactBody>& found);
    /// After solveAgain, for the islands that have changed: which stops bear what contacts push? withStops: else none.
    void noteBearing(bool withStops);
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
    /// Lets the step's forces and the contacts' first guess act: on the free velocities.
    void kick(const BodyStore& bodies);
    /// For others who let forces act: they change the records, and pullFree takes that in.
    void writeFree(BodyStore& bodies) const;
    void pullFree(const BodyStore& bodies);
    void writeVelocities(BodyStore& bodies) const;
    /// By a sub-step of h [s]; fastest: speed at which gaps are closed at most [m/s].
    void move(BodyStore& bodies, double h, double fastest, StepObserver* observer);
    void noteSpeeds() { kernel_->noteSpeeds(view_); }

    /// Solves all joints from the free velocities.
    void solve(BodyStore& bodies, const IslandTurn& turn);
    /// After contacts were solved: where they have changed something, solves again, from the free velocities and the
    /// impulses of the contacts. Returns the lanes in which they have.
    Lanes answerContacts(BodyStore& bodies, const IslandTurn& turn);
    /// The same. Returns true if an island has changed: other stops bear than those with which its contacts were
    /// solved.
    bool solveAgain(BodyStore& bodies, const IslandTurn& turn);
    bool hasChanged(std::size_t lane) const { return changed_[lane] != 0; }
    bool mayChange(std::size_t lane) const { return heavy_[lane] != 0 && layout_->someFree; }
    /// A contact pushes a body in this direction.
    void addNormal(std::size_t lane, std::size_t node, const Vec2& normal) {
        body(node, BodyField::NormalX, lane) += normal.x();
        body(node, BodyField::NormalY, lane) += normal.y();
    }
    /// At the end of half a sub-step: notes the loads.
    void note(StepObserver* observer);
    /// Removes the errors of one island's held rows after the coming h [s].
    void hold(BodyStore& bodies, std::size_t lane, double h, double fastest);

    /// Of a joint that is swept: its bodies have other joints, too, which are in other batches. give: compliance of
    /// rows that hold, in addition [-].
    void sweep(BodyStore& bodies, const IslandTurn& turn, double give, StepObserver* observer);

    // For one island:
    /// By how much the worst joint of one island has opened since the step's start [m].
    double opening(std::size_t lane) const;
    /// Applies an impulse (x, y, turning) to a body, and those of the joints that follow from it.
    void push(BodyStore& bodies, std::size_t lane, std::size_t node, const Vec3& impulse);
    void addLoads(std::size_t lane);
    /// By how much that would change the body's velocity.
    Vec3 answer(std::size_t lane, std::size_t node, const Vec3& impulse);

    const std::vector<JointIsland*>& islands() const { return islands_; }
    std::size_t bytes() const { return bytesOf(numbers_) + bytesOf(islands_) + bytesOf(touching_); }

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
    void findContactBodies(const BodyStore& bodies, const Lanes& lanes, std::vector<ContactBody>& found);
    bool bears(std::size_t row, std::size_t lane) const;
    bool areOthersBearing(const BodyStore& bodies, std::size_t lane) const;
    bool isPushed(const BodyStore& bodies, std::size_t row, std::size_t lane) const;
    bool isHeavy(const BodyStore& bodies, std::size_t lane) const;
    void addContactBodies(std::vector<ContactBody>& found, const BodyStore& bodies, std::size_t lane);
    void loadBody(const BodyStore& bodies, BodyIndex index, std::size_t node, std::size_t lane, double h);
    void loadJoint(const JointForm& form, const JointRecord& record, const BodyStore& bodies, std::size_t j,
                   std::size_t lane, double h);
    void loadRow(const RowForm& form, const Rot& rotationA, double springShare, std::size_t i, std::size_t lane,
                 double h);
    void storeBody(BodyRecord& record, JointIsland::Stiffness& stiffness, std::size_t n, std::size_t lane);
    void storeJoint(JointRecord& record, JointLoad& sum, std::size_t j, std::size_t lane) const;
    /// The change of velocity of a body by an impulse, without the joints'.
    Vec3 changeBy(std::size_t lane, std::size_t node, const Vec3& impulse) const;
    /// To the free velocity. change: by an impulse, in the body's record.
    void addImpulse(const BodyStore& bodies, std::size_t lane, std::size_t node, const SolverVelocity& change);
    void findTouching(const BodyStore& bodies);
    template <class Change>
    void forEachCoordinate(Change&& change);
    void moveInPieces(BodyStore& bodies, double h, double fastest, StepObserver* observer);
    /// Goes on from the velocities at the end of the last piece, with what others have changed since.
    void endPieces();
    void note(StepObserver* observer, double h, bool inPieces);
    IslandTurn ownTurn(IslandTurn turn) const;
    void freeAsIs();
    void predict(const IslandTurn& turn);
    void findSolution(const IslandTurn& turn, const Lanes& lanes, double change);
    Lanes takeContactImpulses(BodyStore& bodies);
    void pullVelocity(const BodyStore& bodies, std::size_t lane, std::size_t node, int field);
    /// Returns true if a place has changed.
    bool pullBody(const BodyStore& bodies, std::size_t lane, std::size_t node, bool moved);
    double errorOf(std::size_t row, std::size_t lane) const;
    void writePlaces(BodyStore& bodies) const;
    void writeVelocities(BodyStore& bodies, int field) const;
    void noteStates();
    void activate(bool all, std::size_t lane);
    Vec2 givenMomentum() const;
    void report(StepObserver& observer) const;
    JointRows rowsOf(std::size_t j, std::size_t lane, Vec3& impulses, Vec3& after, Vec3& slopes) const;

    /// A body with contacts.
    struct Touching {
        std::uint32_t node = 0, lane = 0;
        BodyIndex body = noBody;
    };

    std::vector<JointIsland*> islands_;
    std::vector<Touching> touching_;
    std::shared_ptr<const IslandLayout> layout_;
    const IslandKernel* kernel_ = nullptr;
    std::size_t width_ = 1;
    double h_ = 0;    ///< of the sub-step [s]
    int pieces_ = 1;  ///< in which its islands move in each of them
    IslandLanes view_;
    std::vector<double> numbers_;
    Lanes active_{}, missed_{}, lost_{};
    Lanes pushed_{};      ///< an impact has changed the free velocities
    Lanes heavy_{};       ///< contacts may have to see bodies as heavier than they are
    Lanes changed_{};     ///< of those: other stops bear than those with which contacts were solved
    bool moved_ = false;  ///< others may have moved bodies
};

}  // namespace plumb
