// SPDX-License-Identifier: MIT
// What do joints do in a step?
//
// Each world has a joint solver. At first it is one of this class, which does nothing; the world's first joint puts an
// IslandSolver in its place (island_solver.h). So the linker leaves all code of joints out of a program without joints:
// a page in a browser loads what is left.
#pragma once
#include <memory>
#include <span>
#include <vector>

#include <plumb/dynamics/bodies/step_observer.h>
#include <plumb/dynamics/contacts/contact_graph.h>
#include <plumb/dynamics/contacts/lanes/contact_solver.h>
#include <plumb/dynamics/joints/joint_islands.h>
#include <plumb/dynamics/solver_settings.h>
#include <plumb/impact/detail/meeting.h>
#include <plumb/math/detail/step_list.h>
#include <plumb/math/function_ref.h>

namespace plumb {

/// What joints read and write in a step.
struct JointStores {
    ContactGraph* graph = nullptr;
    ContactStore* contacts = nullptr;
    BodyStore* bodies = nullptr;
    JointStore* joints = nullptr;
    SolverSettings settings = {};
    StepObserver* observer = nullptr;  ///< may be null
    ContactPasses passes = {};
    double h = 0;  ///< of the sub-step [s]
};

/// One half of a sub-step.
struct HalfStep {
    bool correct = false;                  ///< true in the half before the bodies move: corrects position errors too
    bool isFirst = false, isLast = false;  ///< of the step
};

class JointSolver {
public:
    virtual ~JointSolver() = default;
    virtual std::unique_ptr<JointSolver> copy() const { return std::make_unique<JointSolver>(); }

    /// At the start of a step, also if nothing is solved: finds the islands again if the joints have changed. Sorts the
    /// bodies that are solved: those that the islands' own lanes kick and move come last, and those of islands that fly
    /// go. Returns the number of the others.
    virtual std::size_t begin(JointStores, StepList<BodyIndex>& solved) { return solved.size(); }
    /// Takes the islands that touch nothing through the whole step. move: calls this solver's move, and what follows.
    virtual void fly(FunctionRef<void(StepList<BodyIndex>& bodies, int subStep)>) {}
    /// In each half: kicks the bodies in its lanes, solves the joints, then the bounces of jointed bodies, from
    /// velocities with which joints hold, and lets contacts see the bodies with their masses.
    virtual void solve(const HalfStep&) {}
    /// After contacts are solved: lets the joints respond to their impulses, and notes the loads of the joints.
    virtual void respondToContacts(const HalfStep&) {}
    /// After all bodies have moved by a sub-step: moves those in its lanes.
    virtual void move() {}
    /// At the end of the step: stores the loads of the joints. store: called for all bodies of islands; without a move
    /// for those whose records have it.
    virtual void end(FunctionRef<void(BodyIndex, const BodyMove*)>) {}

    // For those who look at an island in a sub-step.
    virtual std::span<JointIsland> islands() { return {}; }
    /// The island that answers for a body as a whole; null if it is alone, or its island is swept.
    virtual JointIsland* islandOf(BodyIndex) { return nullptr; }
    /// By how much impulses on bodies of an island would change their velocities.
    virtual void respond(JointIsland&, std::span<BodyPush>) {}
    /// Applies them, and the reactions of the joints.
    virtual void push(JointIsland&, std::span<BodyPush>) {}
    /// By how much its worst joint has opened since the step's start [m].
    virtual double openingOf(const JointIsland&) { return 0; }
    /// After such impulses: removes the errors of the joints' held rows within a time [s].
    virtual void closeGaps(JointIsland&, double) {}

    // Between steps.
    virtual std::span<const JointIndex> breakable() const { return {}; }                  ///< those that can break
    virtual double springEnergy(const JointStore&, const BodyStore&) const { return 0; }  ///< [J]
    virtual std::size_t bytes() const { return 0; }
};

/// Two bodies as the solver has them in a sub-step: a body alone answers with its own mass, a body of an island with
/// all of its island.
class SolvedBodies final : public MeetingBodies {
public:
    SolvedBodies(BodyStore& bodies, JointSolver& joints, BodyIndex a, BodyIndex b);
    OfBoth velocity() const override;
    OfBoth responseTo(const OfBoth& impulse) override;
    void push(const OfBoth& impulse) override;

private:
    /// Calls act(island, its bodies) where islands answer, and alone(push) for each body alone.
    template <class Act, class Alone>
    OfBoth forEach(const OfBoth& impulse, Act&& act, Alone&& alone);

    BodyStore& bodies_;
    JointSolver& joints_;
    BodyIndex a_, b_;
    JointIsland *islandA_, *islandB_;
};

}  // namespace plumb
