// SPDX-License-Identifier: MIT
// What does the joint solver know of a half of a sub-step?
#pragma once
#include <span>

#include <plumb/dynamics/joints/joint_islands.h>

namespace plumb {

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
