// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/find_islands.h>

#include <algorithm>
#include <map>

#include <plumb/dynamics/bodies/body_groups.h>
#include <plumb/dynamics/joints/joint_bodies.h>

namespace plumb {

namespace {

/// An island is swept if it has more than fewLoops loops and more than one per jointsPerLoop joints, or if it needs
/// more than fewUpdates block updates and more than updatesPerNode per node.
constexpr std::size_t jointsPerLoop = 8;
constexpr std::size_t fewLoops = 16;
constexpr std::size_t updatesPerNode = 8;
constexpr std::size_t fewUpdates = 4000;

void numberNodes(JointIsland& island, const JointStore& joints, const BodyStore& bodies, int atOnce, BlockPlans& plans,
                 std::vector<std::uint32_t>& nodeOf) {
    for (const JointIndex index : island.joints) {
        for (const BodyIndex body : endsOf(joints, index)) {
            if (!bodies.canMove(body) || nodeOf[body] != JointIsland::EndNodes::fixed) continue;
            nodeOf[body] = static_cast<std::uint32_t>(island.bodies.size());
            island.bodies.push_back(body);
        }
    }
    island.stiffness.resize(island.bodies.size());
    std::vector<BlockPlan::Edge> edges;
    std::uint32_t node = static_cast<std::uint32_t>(island.bodies.size());
    for (const JointIndex index : island.joints) {
        JointIsland::EndNodes endNodes;
        const auto ends = endsOf(joints, index);
        for (std::size_t e = 0; e < maxEnds; ++e) {
            if (!bodies.canMove(ends[e])) continue;
            endNodes.node[e] = nodeOf[ends[e]];
            endNodes.edge[e] = edges.size();
            edges.push_back({node, endNodes.node[e]});
        }
        island.endNodes.push_back(endNodes);
        ++node;
    }
    for (const BodyIndex body : island.bodies) nodeOf[body] = JointIsland::EndNodes::fixed;
    const std::size_t loops = edges.size() + 1 - std::min<std::size_t>(edges.size(), node);
    const std::size_t most = std::max(fewUpdates, updatesPerNode * node);
    const bool mayBeDirect = island.joints.size() <= static_cast<std::size_t>(atOnce) &&
                             loops <= std::max(fewLoops, island.joints.size() / jointsPerLoop);
    const std::shared_ptr<const BlockPlan> plan = mayBeDirect ? plans.find(node, edges, most) : nullptr;
    island.direct = plan != nullptr;
    if (island.direct) island.solver = BlockSolver(plan);
    if (!island.direct) island.others = island.hinges.take(island.joints, joints, bodies);
}

}  // namespace

std::vector<JointIsland> findJointIslands(const JointStore& joints, const BodyStore& bodies, int atOnce,
                                          BlockPlans& plans) {
    plans.renew();
    BodyGroups groups(bodies.record.size());
    std::vector<JointIndex> awake;
    for (JointIndex index = 0; index < joints.records.size(); ++index) {
        if (!joints[index].acts() || !holdsSomething(joints, bodies, index)) continue;
        const auto ends = endsOf(joints, index);
        const auto isAwake = [&](BodyIndex body) { return bodies.record[body].awake; };
        const auto isDynamic = [&](BodyIndex body) { return bodies.canMove(body); };
        const auto first = std::find_if(ends.begin(), ends.end(), isDynamic);
        if (std::none_of(ends.begin(), ends.end(), isAwake)) continue;
        awake.push_back(index);
        for (const BodyIndex body : ends)
            if (bodies.canMove(body)) groups.unite(*first, body);
    }
    std::vector<JointIsland> islands;
    std::vector<std::uint32_t> islandOf(bodies.record.size(), none);
    for (const JointIndex index : awake) {
        const auto ends = endsOf(joints, index);
        const BodyIndex body = *std::find_if(ends.begin(), ends.end(), [&](BodyIndex b) { return bodies.canMove(b); });
        std::uint32_t& island = islandOf[groups.of(body)];
        if (island == none) {
            island = static_cast<std::uint32_t>(islands.size());
            islands.emplace_back();
        }
        islands[island].joints.push_back(index);
    }
    std::vector<std::uint32_t> nodeOf(bodies.record.size(), JointIsland::EndNodes::fixed);
    for (JointIsland& island : islands) numberNodes(island, joints, bodies, atOnce, plans, nodeOf);
    return islands;
}

void keepStiffness(const std::vector<JointIsland>& before, std::vector<JointIsland>& islands) {
    std::map<BodyIndex, Vec3> known;
    for (const JointIsland& island : before)
        for (std::size_t b = 0; b < island.bodies.size(); ++b) known.emplace(island.bodies[b], island.stiffness[b]);
    for (JointIsland& island : islands) {
        for (std::size_t b = 0; b < island.bodies.size(); ++b) {
            const auto was = known.find(island.bodies[b]);
            if (was != known.end()) island.stiffness[b] = was->second;
        }
    }
}

}  // namespace plumb
