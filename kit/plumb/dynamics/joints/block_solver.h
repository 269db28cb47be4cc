// SPDX-License-Identifier: MIT
// How is a sparse symmetric system of 3 by 3 blocks solved at once?
//
// A = L D L^T, eliminating one node k after another: A_ij -= A_ik D_k^-1 A_jk^T for all neighbours i, j of k that are
// not yet eliminated. The node with the fewest neighbours is taken first. A tree is therefore eliminated from its
// leaves, without any new blocks (fill-in), at a cost proportional to its size. Positive and negative diagonal blocks
// may mix as they do in [M -J^T; -J -e], M and e positive: such a matrix has this factorisation in any order.
// Source: Vanderbei, "Symmetric quasidefinite matrices", SIAM J. Optim. 5 (1995) 100; minimum degree: Tinney, Walker,
// Proc. IEEE 55 (1967) 1801.
// Test: "a sparse system of blocks is solved as a dense one is"
#pragma once
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <plumb/math/detail/bytes_of.h>
#include <plumb/math/detail/mat3.h>

namespace plumb {

class BlockSolver {
public:
    using Edge = std::pair<std::uint32_t, std::uint32_t>;

    /// Finds the order of elimination for a graph; each edge joins two different nodes. Returns false when the
    /// elimination would take more than mostUpdates block updates; no other function may be called then.
    bool analyse(std::uint32_t nodes, std::span<const Edge> edges, std::size_t mostUpdates);

    // Then, for each matrix of this structure: clear, fill in, factor, solve.
    void clear();
    Mat3& diagonal(std::uint32_t node) { return blocks_[node]; }
    /// Adds m to the block of the edge (a, b), with a as the row node and b as the column node.
    void add(std::size_t edge, const Mat3& m);
    void factor();
    /// Replaces the right side by the solution.
    void solve(std::span<Vec3> x) const;

    std::size_t bytes() const {
        return bytesOf(blocks_) + bytesOf(places_) + bytesOf(steps_) + bytesOf(lowers_) + bytesOf(updates_);
    }

private:
    struct Lower {
        std::uint32_t node = 0;   ///< eliminated later
        std::uint32_t block = 0;  ///< index of the block (node, eliminated node)
    };
    struct Place {
        std::uint32_t block = 0;
        bool transposed = false;
    };
    struct Update {
        std::uint32_t target = 0, left = 0, right = 0;  ///< target -= left D^-1 right^T
    };
    struct Step {
        std::uint32_t node = 0;
        std::uint32_t firstLower = 0, firstUpdate = 0;
    };

    std::vector<Mat3> blocks_;   ///< diagonals first; after factor, their inverses
    std::vector<Place> places_;  ///< for each edge, where its block is
    std::vector<Step> steps_;    ///< in the order of elimination, and one past the end
    std::vector<Lower> lowers_;
    std::vector<Update> updates_;
};

}  // namespace plumb
