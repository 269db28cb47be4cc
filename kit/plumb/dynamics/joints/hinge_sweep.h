// SPDX-License-Identifier: MIT
// Which plain hinges of a swept island can be solved in parallel?
#pragma once
#include <plumb/dynamics/joints/hinge_solver.h>
#include <plumb/dynamics/joints/joint_store.h>
#include <plumb/math/detail/arrays.h>

namespace plumb {

/// Batches of hinges without motor, limit or spring, coloured so that no lanes of a batch share a body that can be
/// pushed.
class HingeSweep {
public:
    /// Takes over the plain hinges among the joints, with their impulses. Returns the other joints in their order.
    std::vector<JointIndex> take(const std::vector<JointIndex>& joints, const JointStore& store,
                                 const BodyStore& bodies);
    /// Writes the impulses back to the joints' records; to be called before this object is destroyed.
    void release(JointStore& store) const;

    void prepare(const HingeSolver& solver, const BodyStore& bodies);
    void solve(const HingeSolver& solver, const SolverBodies& bodies, const HingePass& pass);
    /// Adds the impulses of the step to the joints' loads.
    void addLoads(JointStore& store) const;

    std::size_t bytes() const { return bytesOf(batches_) + bytesOf(jointOf_); }

private:
    std::vector<HingeBatch> batches_;
    std::vector<JointIndex> jointOf_;          ///< batch * batchLanes + lane; none for an empty lane
    std::vector<std::uint32_t> generationOf_;  ///< of those joints
};

}  // namespace plumb
