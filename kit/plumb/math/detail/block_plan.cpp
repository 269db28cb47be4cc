// SPDX-License-Identifier: MIT
#include <plumb/math/detail/block_plan.h>

#include <map>
#include <set>
#include <tuple>

namespace plumb {

namespace {

/// The graph of the nodes that are not yet eliminated; each edge has the index of its block.
struct Graph {
    std::vector<std::map<std::uint32_t, std::uint32_t>> blockTo;  ///< of each node: neighbour to block
    std::vector<bool> mayGo;                                      ///< of each node: it may be eliminated next
    /// Of those that may: degree, since when it has it, node. So of equal ones that goes first which has waited
    /// longest: both ends of a chain go in turn, and the processor need not wait for the one while it works on the
    /// other.
    std::set<std::tuple<std::size_t, std::uint32_t, std::uint32_t>> byDegree;
    std::vector<std::uint32_t> since;   ///< of each node
    std::vector<std::uint32_t> leaves;  ///< of each unknown: constraints that go right after it
    std::uint32_t blocks = 0, changes = 0;

    std::size_t degreeOf(std::uint32_t node, std::size_t neighbours) const { return neighbours - leaves[node]; }

    void add(std::uint32_t node) {
        since[node] = changes++;
        byDegree.insert({degreeOf(node, blockTo[node].size()), since[node], node});
    }
    void setDegree(std::uint32_t node, std::size_t before) {
        if (!mayGo[node]) return;
        byDegree.erase({degreeOf(node, before), since[node], node});
        add(node);
    }
    void release(std::uint32_t node) {
        if (mayGo[node]) return;
        mayGo[node] = true;
        add(node);
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
        byDegree.erase({degreeOf(node, blockTo[node].size()), since[node], node});
        for (const auto& [other, block] : blockTo[node]) {
            blockTo[other].erase(node);
            setDegree(other, blockTo[other].size() + 1);
        }
    }
};

}  // namespace

std::shared_ptr<const BlockPlan> planBlocks(std::uint32_t unknowns, std::uint32_t constraints,
                                            std::span<const BlockPlan::Edge> edges, std::size_t mostUpdates,
                                            bool fromWalls) {
    const std::uint32_t nodes = unknowns + constraints;
    auto plan = std::make_shared<BlockPlan>();
    Graph graph;
    graph.blockTo.resize(nodes);
    graph.blocks = nodes;
    graph.mayGo.resize(nodes);
    graph.since.resize(nodes);
    graph.leaves.resize(nodes);
    for (const BlockPlan::Edge& edge : edges) plan->places.push_back({graph.connect(edge.first, edge.second), false});
    for (std::uint32_t node = unknowns; node < nodes && fromWalls; ++node)
        if (graph.blockTo[node].size() == 1) ++graph.leaves[graph.blockTo[node].begin()->first];
    for (std::uint32_t node = 0; node < unknowns; ++node) graph.release(node);
    std::vector<std::uint32_t> rank(nodes);
    // The row of a block is the node that is eliminated later: for new blocks (fill-in) known once all nodes have a
    // rank.
    while (!graph.byDegree.empty()) {
        const std::uint32_t node = std::get<2>(*graph.byDegree.begin());
        rank[node] = static_cast<std::uint32_t>(plan->steps.size());
        plan->steps.push_back(
            {node, static_cast<std::uint32_t>(plan->lowers.size()), static_cast<std::uint32_t>(plan->updates.size())});
        const std::map<std::uint32_t, std::uint32_t> around = graph.blockTo[node];
        graph.remove(node);
        for (const auto& [i, left] : around) graph.release(i);
        for (const auto& [i, left] : around) {
            plan->lowers.push_back({i, left});
            for (const auto& [j, right] : around) {
                if (j > i) break;
                plan->updates.push_back({i == j ? i : graph.connect(i, j), left, right});
            }
        }
        if (plan->updates.size() > mostUpdates) return nullptr;
    }
    plan->steps.push_back(
        {0, static_cast<std::uint32_t>(plan->lowers.size()), static_cast<std::uint32_t>(plan->updates.size())});
    // A block's row is the later of its two nodes. Updates were noted as (i, j), i above j by number.
    for (std::size_t k = 0; k + 1 < plan->steps.size(); ++k) {
        std::size_t update = plan->steps[k].firstUpdate;
        for (std::size_t a = plan->steps[k].firstLower; a < plan->steps[k + 1].firstLower; ++a) {
            for (std::size_t b = plan->steps[k].firstLower; b <= a; ++b, ++update)
                if (rank[plan->lowers[a].node] < rank[plan->lowers[b].node])
                    std::swap(plan->updates[update].left, plan->updates[update].right);
        }
    }
    for (std::size_t e = 0; e < edges.size(); ++e)
        plan->places[e].transposed = rank[edges[e].first] < rank[edges[e].second];
    plan->blocks = graph.blocks;
    return plan;
}

}  // namespace plumb
