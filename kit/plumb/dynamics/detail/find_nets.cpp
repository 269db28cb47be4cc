// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <numeric>

#include <plumb/dynamics/detail/joint_bodies.h>
#include <plumb/dynamics/detail/joint_net.h>

namespace plumb {

namespace {

/// Sets of bodies that hang together, each known by one of them.
class Groups {
public:
    explicit Groups(std::size_t bodies) : parent_(bodies) { std::iota(parent_.begin(), parent_.end(), BodyIndex{0}); }
    BodyIndex of(BodyIndex body) {
        while (parent_[body] != body) body = parent_[body] = parent_[parent_[body]];
        return body;
    }
    void unite(BodyIndex a, BodyIndex b) { parent_[std::max(of(a), of(b))] = std::min(of(a), of(b)); }

private:
    std::vector<BodyIndex> parent_;
};

/// A machine whose loops are more than this share of its joints, or that takes more block updates than that, is swept.
constexpr std::size_t joinsPerLoop = 8;
constexpr std::size_t fewLoops = 16;
constexpr std::size_t updatesPerNode = 8;
constexpr std::size_t fewUpdates = 4000;

void seat(JointNet& net, const JointStore& joints, const BodyStore& bodies, int atOnce,
          std::vector<std::uint32_t>& nodeOf) {
    for (const JointIndex index : net.joints) {
        for (const BodyIndex body : endsOf(joints, index)) {
            if (!bodies.canMove(body) || nodeOf[body] != JointNet::Seats::fixed) continue;
            nodeOf[body] = static_cast<std::uint32_t>(net.bodies.size());
            net.bodies.push_back(body);
        }
    }
    net.stiffness.resize(net.bodies.size());
    std::vector<BlockSolver::Edge> edges;
    std::uint32_t node = static_cast<std::uint32_t>(net.bodies.size());
    for (const JointIndex index : net.joints) {
        JointNet::Seats seats;
        const auto ends = endsOf(joints, index);
        for (std::size_t e = 0; e < mostEnds; ++e) {
            if (!bodies.canMove(ends[e])) continue;
            seats.node[e] = nodeOf[ends[e]];
            seats.edge[e] = edges.size();
            edges.push_back({node, seats.node[e]});
        }
        net.seats.push_back(seats);
        ++node;
    }
    for (const BodyIndex body : net.bodies) nodeOf[body] = JointNet::Seats::fixed;
    const std::size_t loops = edges.size() + 1 - std::min<std::size_t>(edges.size(), node);
    const std::size_t most = std::max(fewUpdates, updatesPerNode * node);
    net.direct = net.joints.size() <= static_cast<std::size_t>(atOnce) &&
                 loops <= std::max(fewLoops, net.joints.size() / joinsPerLoop) && net.solver.analyse(node, edges, most);
    if (!net.direct) net.others = net.hinges.take(net.joints, joints, bodies);
}

}  // namespace

std::vector<JointNet> findNets(const JointStore& joints, const BodyStore& bodies, int atOnce) {
    Groups groups(bodies.record.size());
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
    std::vector<JointNet> nets;
    std::vector<std::uint32_t> netOf(bodies.record.size(), none);
    for (const JointIndex index : awake) {
        const auto ends = endsOf(joints, index);
        const BodyIndex body = *std::find_if(ends.begin(), ends.end(), [&](BodyIndex b) { return bodies.canMove(b); });
        std::uint32_t& net = netOf[groups.of(body)];
        if (net == none) {
            net = static_cast<std::uint32_t>(nets.size());
            nets.emplace_back();
        }
        nets[net].joints.push_back(index);
    }
    std::vector<std::uint32_t> nodeOf(bodies.record.size(), JointNet::Seats::fixed);
    for (JointNet& net : nets) seat(net, joints, bodies, atOnce, nodeOf);
    return nets;
}

void keepStiffness(const std::vector<JointNet>& before, std::vector<JointNet>& nets) {
    std::map<BodyIndex, Vec3> known;
    for (const JointNet& net : before)
        for (std::size_t b = 0; b < net.bodies.size(); ++b) known.emplace(net.bodies[b], net.stiffness[b]);
    for (JointNet& net : nets) {
        for (std::size_t b = 0; b < net.bodies.size(); ++b) {
            const auto was = known.find(net.bodies[b]);
            if (was != known.end()) net.stiffness[b] = was->second;
        }
    }
}

}  // namespace plumb
