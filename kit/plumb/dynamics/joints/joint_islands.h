// SPDX-License-Identifier: MIT
// Which islands do the joints of a world form, and how are these solved side by side?
#pragma once
#include <span>
#include <vector>

#include <plumb/dynamics/joints/joint_batch.h>
#include <plumb/dynamics/joints/joint_island.h>

namespace plumb {

/// The islands of all joints that act and have an awake body.
struct JointIslands {
    std::vector<JointIsland> islands;               ///< in the order of their first joints
    std::vector<std::vector<std::uint32_t>> alike;  ///< numbers of those that are not swept, for each layout
    std::vector<JointBatch> batches;                ///< in this step; its islands keep pointers to them
    std::size_t batchCount = 0;                     ///< those in use
    std::size_t meeting = 0;                        ///< the first of these: the others meet no contact in this step
    std::vector<JointIndex> joints;                 ///< of all islands, in the order of their slots
    std::vector<JointIndex> breakable;              ///< those of the joints that can break
    IslandLayouts layouts;

    /// Those whose islands meet contacts, or something else that may push them in this step; then the others in use.
    std::span<JointBatch> meetingBatches() { return {batches.data(), meeting}; }
    std::span<JointBatch> flyingBatches() { return {batches.data() + meeting, batchCount - meeting}; }
    std::size_t bytes() const;
};

/// Finds the islands of all joints that act and have an awake body, in the order of their first joints. Those whose
/// joints and bodies were not edited keep their layouts.
void findJointIslands(JointIslands& found, JointStore& joints, const BodyStore& bodies);

}  // namespace plumb
