// SPDX-License-Identifier: MIT
// How is a sparse symmetric system of 3 by 3 blocks solved at once?
//
// A = L D L^T, node after node: A_ij -= A_ik D_k^-1 A_jk^T for what is left of k's neighbours i, j. The order takes the
// node with the fewest neighbours first, so that a tree, from its leaves on, fills in nothing, and costs in proportion
// to its size. Positive and negative diagonal blocks may mix as they do in [M -J^T; -J -e], M and e positive: such a
// matrix has this factorisation in any order.
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

    /// Finds the order of a graph of nodes and edges between different ones. False, and nothing else is to be asked of
    /// it, when the elimination would take more than so many block updates.
    bool analyse(std::uint32_t nodes, std::span<const Edge> edges, std::size_t mostUpdates);

    // Then, for each set of numbers: clear, fill in, factor, solve.
    void clear();
    Mat3& diagonal(std::uint32_t node) { return blocks_[node]; }
    /// Adds m, as seen from row node a and column node b, to the block of an edge.
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
        std::uint32_t block = 0;  ///< of (node, this)
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
    std::vector<Place> places_;  ///< of the edges
    std::vector<Step> steps_;    ///< in the order of elimination, and one past the end
    std::vector<Lower> lowers_;
    std::vector<Update> updates_;
};

}  // namespace plumb
