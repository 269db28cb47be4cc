// SPDX-License-Identifier: MIT
// What does the joint solver know of a world?
#pragma once
#include <span>
#include <vector>

#include <plumb/dynamics/bodies/step_observer.h>
#include <plumb/dynamics/joints/joint_batch.h>
#include <plumb/dynamics/joints/joint_island.h>
#include <plumb/dynamics/solver_settings.h>

namespace plumb {

/// The islands of all joints that act and have an awake body.
struct JointIslands {
    std::vector<JointIsland> islands;               ///< in the order of their first joints
    std::vector<std::vector<std::uint32_t>> alike;  ///< numbers of those that are not swept, for each layout
    std::vector<JointIsland> swept;                 ///< other joints than hinges of swept islands, each as an island
    std::vector<JointBatch> batches;                ///< in this step; its islands keep pointers to them
    std::size_t batchCount = 0;                     ///< those in use for islands that are not swept
    std::size_t meeting = 0;                        ///< the first of these: the others meet no contact in this step
    std::vector<JointBatch> sweptBatches;           ///< of each swept joint
    std::vector<JointIndex> joints;                 ///< of all islands, in the order of their slots
    std::vector<JointIndex> breakable;              ///< those of the joints that can break
    IslandLayouts layouts;
};

/// The stores that the joint solver reads and writes.
struct JointStores {
    JointStore& joints;
    JointIslands& islands;
    BodyStore& bodies;
    const SolverSettings& settings;
    StepObserver* observer = nullptr;  ///< may be null
};

/// Finds the islands of all joints that act and have an awake body, in the order of their first joints. Those whose
/// joints and bodies were not edited keep their layouts.
void findJointIslands(JointIslands& found, JointStore& joints, const BodyStore& bodies);

/// One half of a sub-step.
struct JointHalf {
    double step = 0;       ///< of the sub-step [s]
    bool correct = false;  ///< true in the half before the bodies move: corrects position errors too
    bool isFirst = false;  ///< of the step
};

inline IslandTurn turnOf(const JointStores& stores, const JointHalf& half) {
    return {half.step, half.correct, false, stores.settings.contactPushSpeed};
}

/// The batches whose islands meet contacts, or something else that may push them in this step.
inline std::span<JointBatch> batchesOf(const JointStores& stores) {
    return {stores.islands.batches.data(), stores.islands.meeting};
}
/// The other batches in use.
inline std::span<JointBatch> flyingBatchesOf(const JointStores& stores) {
    return {stores.islands.batches.data() + stores.islands.meeting, stores.islands.batchCount - stores.islands.meeting};
}

}  // namespace plumb
