// SPDX-License-Identifier: MIT
// How are the joints of a world solved? The joint solver of a world that has joints.
//
// Joints that are connected through bodies form an island, and are solved together: equal islands side by side, in
// batches (joint_batch.h). An island with many loops is swept, joint by joint. Islands that touch nothing go through a
// whole step at once.
#pragma once
#include <plumb/dynamics/jointed/joint_bounces.h>
#include <plumb/dynamics/jointed/joint_contacts.h>
#include <plumb/dynamics/jointed/joint_solver.h>

namespace plumb {

class IslandSolver final : public JointSolver {
public:
    std::unique_ptr<JointSolver> copy() const override { return std::make_unique<IslandSolver>(*this); }

    std::size_t begin(JointStores stores, StepList<BodyIndex>& solved) override;
    void fly(FunctionRef<void(StepList<BodyIndex>& bodies, int subStep)> move) override;
    void solve(const HalfStep& half) override;
    void respondToContacts(const HalfStep& half) override;
    void move() override;
    void end(FunctionRef<void(BodyIndex, const BodyMove*)> store) override;

    std::span<JointIsland> islands() override { return islands_.islands; }
    JointIsland* islandOf(BodyIndex body) override;
    void respond(JointIsland& island, std::span<BodyPush> pushes) override;
    void push(JointIsland& island, std::span<BodyPush> pushes) override;
    double openingOf(const JointIsland& island) override { return island.batch->numbers.openingOf(island.lane); }
    void closeGaps(JointIsland& island, double time) override;

    std::span<const JointIndex> breakable() const override { return islands_.breakable; }
    double springEnergy(const JointStore& joints, const BodyStore& bodies) const override;
    std::size_t bytes() const override { return islands_.bytes(); }

private:
    void findIslands();
    void choosePieces(JointIsland& island) const;
    StepList<std::span<JointIsland*>> cutBatches(StepList<JointIsland*>& order);
    void loadBatches();
    std::size_t sortBodies(StepList<BodyIndex>& solved);
    void sweep(JointIsland& island, const HalfStep& half);
    template <class Visit>
    void forEachSwept(Visit&& visit);
    IslandTurn turnOf(const HalfStep& half) const;
    template <class Change>
    void reportGround(const std::vector<BodyIndex>& bodies, Change&& change);

    JointIslands islands_;

    // Of the present step:
    JointStores stores_;
    double dt_ = 0;
    std::span<JointBatch> moving_;         ///< batches that move with the next call
    std::vector<std::uint32_t> islandOf_;  ///< of each body; none: in no island, or in a swept one
    JointBounces bounces_;
    JointedContacts contacts_;
    bool flying_ = false;  ///< in fly
    bool inHalf_ = false;  ///< from solve to respondToContacts
};

/// One without joints: worlds get a copy of it (see Lock).
const JointSolver& islandSolver();

}  // namespace plumb
