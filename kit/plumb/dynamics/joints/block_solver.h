// SPDX-License-Identifier: MIT
// How is a sparse symmetric system of 3 by 3 blocks solved at once?
//
// A = L D L^T, eliminating one node k after another: A_ij -= A_ik D_k^-1 A_jk^T for all neighbours i, j of k that are
// not yet eliminated, in the order of a plan. Positive and negative diagonal blocks may mix as they do in [M -J^T; -J
// -e], M and e positive: such a matrix has this factorisation in any order.
// Source: Vanderbei, "Symmetric quasidefinite matrices", SIAM J. Optim. 5 (1995) 100.
// Test: "a sparse system of blocks is solved as a dense one is"
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <plumb/dynamics/joints/block_plan.h>
#include <plumb/math/detail/mat3.h>

namespace plumb {

class BlockSolver {
public:
    BlockSolver() = default;
    /// For matrices of the structure of a plan, which is not null.
    explicit BlockSolver(std::shared_ptr<const BlockPlan> plan) : plan_(std::move(plan)), blocks_(plan_->blocks) {}

    // For each matrix: clear, fill in, factor, solve.
    void clear();
    Mat3& diagonal(std::uint32_t node) { return blocks_[node]; }
    /// Adds m to the block of the edge (a, b), with a as the row node and b as the column node.
    void add(std::size_t edge, const Mat3& m);
    void factor();
    /// Replaces the right side by the solution.
    void solve(std::span<Vec3> x) const;

    std::size_t bytes() const { return bytesOf(blocks_); }

private:
    std::shared_ptr<const BlockPlan> plan_;
    std::vector<Mat3> blocks_;  ///< diagonals first; after factor, their inverses
};

}  // namespace plumb
