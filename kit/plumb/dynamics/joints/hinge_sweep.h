// SPDX-License-Identifier: MIT
// Which plain hinges of a island that is swept go side by side?
#pragma once
#include <plumb/dynamics/joints/hinge_solver.h>
#include <plumb/dynamics/joints/joint_store.h>
#include <plumb/math/detail/bytes_of.h>

namespace plumb {

/// Batches of hinges without motor, limit or spring, coloured so that no lanes of a batch share a body that can be
/// pushed.
class HingeSweep {
public:
    /// Takes those of the joints that it can, and their impulses with them; gives the others back, in their order.
    std::vector<JointIndex> take(const std::vector<JointIndex>& joints, const JointStore& store,
                                 const BodyStore& bodies);
    /// Gives the impulses back to the joints' records: before it is forgotten.
    void release(JointStore& store) const;

    void prepare(const HingeSolver& solver, const BodyStore& bodies);
    void solve(const HingeSolver& solver, const SolverBodies& bodies, const HingePass& pass);
    /// Adds what the step's impulses were to the joints' loads.
    void addLoads(JointStore& store) const;

    std::size_t bytes() const { return bytesOf(batches_) + bytesOf(jointOf_); }

private:
    std::vector<HingeBatch> batches_;
    std::vector<JointIndex> jointOf_;          ///< batch * batchLanes + lane; none for an empty lane
    std::vector<std::uint32_t> generationOf_;  ///< of those joints
};

}  // namespace plumb
