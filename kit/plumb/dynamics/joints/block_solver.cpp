// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/block_solver.h>

#include <algorithm>
#include <map>
#include <set>

namespace plumb {

namespace {

Mat3 transposed(const Mat3& m) {
    Mat3 result;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) result[i][j] = m[j][i];
    return result;
}

/// The graph of the nodes that are not yet eliminated; each edge has the index of its block.
struct Graph {
    std::vector<std::map<std::uint32_t, std::uint32_t>> blockTo;  ///< of each node: neighbour to block
    std::set<std::pair<std::size_t, std::uint32_t>> byDegree;
    std::uint32_t blocks = 0;

    void setDegree(std::uint32_t node, std::size_t before) {
        byDegree.erase({before, node});
        byDegree.insert({blockTo[node].size(), node});
    }
    /// The block between two nodes; a new one if there was none.
    std::uint32_t connect(std::uint32_t a, std::uint32_t b) {
        const auto [known, isNew] = blockTo[a].try_emplace(b, blocks);
        if (!isNew) return known->second;
        blockTo[b].emplace(a, blocks);
        setDegree(a, blockTo[a].size() - 1);
        setDegree(b, blockTo[b].size() - 1);
        return blocks++;
    }
    void remove(std::uint32_t node) {
        byDegree.erase({blockTo[node].size(), node});
        for (const auto& [other, block] : blockTo[node]) {
            blockTo[other].erase(node);
            setDegree(other, blockTo[other].size() + 1);
        }
    }
};

}  // namespace

bool BlockSolver::analyse(std::uint32_t nodes, std::span<const Edge> edges, std::size_t mostUpdates) {
    Graph graph;
    graph.blockTo.resize(nodes);
    graph.blocks = nodes;
    for (std::uint32_t node = 0; node < nodes; ++node) graph.byDegree.insert({0, node});
    places_.clear();
    for (const Edge& edge : edges) places_.push_back({graph.connect(edge.first, edge.second), false});
    steps_.clear();
    lowers_.clear();
    updates_.clear();
    std::vector<std::uint32_t> rank(nodes);
    // The row of a block is the node that is eliminated later: for new blocks (fill-in) known once all nodes have a
    // rank.
    std::vector<Update> found;
    while (!graph.byDegree.empty()) {
        const std::uint32_t node = graph.byDegree.begin()->second;
        rank[node] = static_cast<std::uint32_t>(steps_.size());
        steps_.push_back(
            {node, static_cast<std::uint32_t>(lowers_.size()), static_cast<std::uint32_t>(updates_.size())});
        const std::map<std::uint32_t, std::uint32_t> around = graph.blockTo[node];
        graph.remove(node);
        for (const auto& [i, left] : around) {
            lowers_.push_back({i, left});
            for (const auto& [j, right] : around) {
                if (j > i) break;
                updates_.push_back({i == j ? i : graph.connect(i, j), left, right});
            }
        }
        if (updates_.size() > mostUpdates) return false;
    }
    steps_.push_back({0, static_cast<std::uint32_t>(lowers_.size()), static_cast<std::uint32_t>(updates_.size())});
    // A block's row is the later of its two nodes. Updates were noted as (i, j), i above j by number.
    for (std::size_t k = 0; k + 1 < steps_.size(); ++k) {
        std::size_t update = steps_[k].firstUpdate;
        for (std::size_t a = steps_[k].firstLower; a < steps_[k + 1].firstLower; ++a) {
            for (std::size_t b = steps_[k].firstLower; b <= a; ++b, ++update)
                if (rank[lowers_[a].node] < rank[lowers_[b].node])
                    std::swap(updates_[update].left, updates_[update].right);
        }
    }
    for (std::size_t e = 0; e < edges.size(); ++e) places_[e].transposed = rank[edges[e].first] < rank[edges[e].second];
    blocks_.resize(graph.blocks);
    return true;
}

void BlockSolver::clear() {
    std::fill(blocks_.begin(), blocks_.end(), Mat3{});
}

void BlockSolver::add(std::size_t edge, const Mat3& m) {
    Mat3& block = blocks_[places_[edge].block];
    const Mat3 added = places_[edge].transposed ? transposed(m) : m;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) block[i][j] += added[i][j];
}

void BlockSolver::factor() {
    for (std::size_t k = 0; k + 1 < steps_.size(); ++k) {
        Mat3& inverse = blocks_[steps_[k].node];
        inverse = symmetricInverse(inverse);
        std::uint32_t last = 0;
        Mat3 scaled;
        for (std::size_t u = steps_[k].firstUpdate; u < steps_[k + 1].firstUpdate; ++u) {
            const Update& update = updates_[u];
            if (u == steps_[k].firstUpdate || update.left != last) scaled = blocks_[update.left] * inverse;
            last = update.left;
            subtractTimesTransposed(blocks_[update.target], scaled, blocks_[update.right]);
        }
    }
}

void BlockSolver::solve(std::span<Vec3> x) const {
    for (std::size_t k = 0; k + 1 < steps_.size(); ++k) {
        if (steps_[k].firstLower == steps_[k + 1].firstLower) continue;
        const Vec3 scaled = blocks_[steps_[k].node] * x[steps_[k].node];
        for (std::size_t l = steps_[k].firstLower; l < steps_[k + 1].firstLower; ++l)
            subtract(x[lowers_[l].node], blocks_[lowers_[l].block] * scaled);
    }
    for (std::size_t k = steps_.size() - 1; k-- > 0;) {
        Vec3 right = x[steps_[k].node];
        for (std::size_t l = steps_[k].firstLower; l < steps_[k + 1].firstLower; ++l)
            subtract(right, transposeTimes(blocks_[lowers_[l].block], x[lowers_[l].node]));
        // D^-1 (b - sum D L^T x): the sum holds A_ik^T x_i as it stands
        x[steps_[k].node] = blocks_[steps_[k].node] * right;
    }
}

}  // namespace plumb
