// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/joint_islands.h>

#include <algorithm>
#include <map>
#include <numeric>

#include <plumb/math/detail/disjoint_sets.h>

namespace plumb {

namespace {

/// How many bodies lie on the shortest way from those that impulses do not move to the farthest one, with both; of an
/// island without any, half of those from its first body.
std::size_t levelsOf(std::size_t moved, std::size_t all, const std::vector<LaidJoint>& laid) {
    std::vector<std::vector<std::uint32_t>> beside(all);
    for (const LaidJoint& joint : laid)
        for (std::size_t k = 0; k < joint.form.links; ++k) {
            beside[joint.link[k].a].push_back(joint.link[k].b);
            beside[joint.link[k].b].push_back(joint.link[k].a);
        }
    std::vector<std::size_t> level(all, none);
    std::vector<std::uint32_t> order(std::max(all - moved, std::size_t{1}));
    std::iota(order.begin(), order.end(), static_cast<std::uint32_t>(moved < all ? moved : 0));
    for (const std::uint32_t node : order) level[node] = 0;
    for (std::size_t i = 0; i < order.size(); ++i)
        for (const std::uint32_t other : beside[order[i]])
            if (level[other] == none) {
                level[other] = level[order[i]] + 1;
                order.push_back(other);
            }
    const std::size_t most = level[order.back()] + 1;
    return moved < all ? most : most / 2;
}

/// Numbers the bodies of an island, and finds its layout. Bodies are numbered in the order in which its joints name
/// them, and those that impulses do not move after all others: so islands that are built alike get equal numbers, share
/// a layout, and can be solved side by side.
class Numbering {
public:
    Numbering(const JointStore& joints, const BodyStore& bodies)
        : joints_(joints), bodies_(bodies), nodeOf_(bodies.record.size(), none) {}

    void number(JointIsland& island, IslandLayouts& layouts) {
        for (const JointIndex index : island.joints)
            for (const BodyIndex body : endsOf(joints_, index))
                if (bodies_.canMove(body)) add(island.bodies, body, 0);
        island.stiffness.resize(island.bodies.size());
        std::vector<LaidJoint> laid;
        laid.reserve(island.joints.size());
        for (const JointIndex index : island.joints) {
            LaidJoint& joint = laid.emplace_back(LaidJoint{joints_.formOf(index), {}});
            for (std::size_t k = 0; k < joint.form.links; ++k)
                joint.link[k] = {nodeOf(island, joint.form.link[k].a.body), nodeOf(island, joint.form.link[k].b.body)};
        }
        const std::size_t all = island.bodies.size() + island.held.size();
        const bool allTurn = std::all_of(island.bodies.begin(), island.bodies.end(),
                                         [this](BodyIndex body) { return bodies_.record[body].inverseInertia > 0; });
        island.layout = layouts.find(static_cast<std::uint32_t>(island.bodies.size()), static_cast<std::uint32_t>(all),
                                     allTurn, laid);
        for (std::uint32_t j = 0; j < laid.size(); ++j)
            if (laid[j].form.hasSpring()) island.sprung.push_back(j);
        if (island.isSwept()) {
            island.sweptJoints.take(island.joints, laid, joints_, bodies_);
            island.levels = levelsOf(island.bodies.size(), all, laid);
        } else {
            island.laid = std::move(laid);
        }
        for (const std::vector<BodyIndex>* some : {&island.bodies, &island.held})
            for (const BodyIndex body : *some) nodeOf_[body] = none;
    }

private:
    void add(std::vector<BodyIndex>& to, BodyIndex body, std::size_t first) {
        if (nodeOf_[body] != none) return;
        nodeOf_[body] = static_cast<std::uint32_t>(first + to.size());
        to.push_back(body);
    }
    std::uint32_t nodeOf(JointIsland& island, BodyIndex body) {
        if (!bodies_.canMove(body)) add(island.held, body, island.bodies.size());
        return nodeOf_[body];
    }

    const JointStore& joints_;
    const BodyStore& bodies_;
    std::vector<std::uint32_t> nodeOf_;
};

/// The islands that there were. One joint that is added or broken makes all islands be found again; those that it does
/// not touch must not lose their layouts, which are dear, nor their bodies' stiffness and the energy that joints have
/// taken, which are known from past steps.
class IslandsBefore {
public:
    IslandsBefore(std::vector<JointIsland>&& islands, const JointStore& joints, std::size_t bodies)
        : islands_(std::move(islands)),
          joints_(joints),
          islandOf_(joints.records.size(), none),
          stiffness_(bodies),
          energy_(bodies) {
        for (std::uint32_t i = 0; i < islands_.size(); ++i) {
            const JointIsland& island = islands_[i];
            if (!island.isSwept()) islandOf_[island.joints.front()] = i;
            for (std::size_t b = 0; b < island.bodies.size(); ++b) stiffness_[island.bodies[b]] = island.stiffness[b];
            energy_[island.bodies.front()] = {island.energy, island.lost};
        }
    }

    /// Takes over the whole island, if there is one of the same joints and nothing was edited.
    bool takeOver(JointIsland& island) {
        const std::uint32_t i = islandOf_[island.joints.front()];
        if (i == none || islands_[i].joints != island.joints) return false;
        for (const JointIndex joint : island.joints)
            if (joints_[joint].edited) return false;
        island = std::move(islands_[i]);
        return true;
    }

    void keepState(JointIsland& island) const {
        for (std::size_t b = 0; b < island.bodies.size(); ++b) {
            island.stiffness[b] = stiffness_[island.bodies[b]];
            island.energy += energy_[island.bodies[b]].first;
            island.lost += energy_[island.bodies[b]].second;
        }
    }

private:
    std::vector<JointIsland> islands_;
    const JointStore& joints_;
    std::vector<std::uint32_t> islandOf_;            ///< of its first joint
    std::vector<JointIsland::Stiffness> stiffness_;  ///< of each body
    std::vector<std::pair<double, double>> energy_;  ///< of each island and what it lost, at its first body
};

/// Groups are in the order of their first islands, not of their layouts' addresses: else runs would differ.
void groupAlike(JointIslands& found) {
    found.alike.clear();
    std::map<const IslandLayout*, std::size_t> groupOf;
    for (std::uint32_t i = 0; i < found.islands.size(); ++i) {
        JointIsland& island = found.islands[i];
        if (island.isSwept()) continue;
        const auto [group, isNew] = groupOf.try_emplace(island.layout.get(), found.alike.size());
        if (isNew) found.alike.emplace_back();
        found.alike[group->second].push_back(i);
    }
}

/// Islands with only their joints. Bodies that impulses do not move connect nothing: two pendulums on one wall are two
/// islands.
std::vector<JointIsland> islandsOf(const JointStore& joints, const BodyStore& bodies) {
    DisjointSets groups(bodies.record.size());
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
    return islands;
}

}  // namespace

std::size_t JointIslands::bytes() const {
    std::size_t bytes = bytesOf(joints) + bytesOf(breakable) + bytesOf(alike) + layouts.bytes() + bytesOf(islands);
    for (const JointIsland& island : islands)
        bytes += bytesOf(island.joints) + bytesOf(island.laid) + bytesOf(island.sprung) + bytesOf(island.held) +
                 bytesOf(island.bodies) + bytesOf(island.stiffness) + island.sweptJoints.bytes() +
                 island.sweptPieces.bytes();
    for (const std::vector<std::uint32_t>& group : alike) bytes += bytesOf(group);
    for (const JointBatch& batch : batches) bytes += sizeof(JointBatch) + batch.bytes();
    return bytes;
}

void findJointIslands(JointIslands& found, JointStore& joints, const BodyStore& bodies) {
    found.layouts.renew();
    IslandsBefore before(std::move(found.islands), joints, bodies.record.size());
    found.islands = islandsOf(joints, bodies);
    Numbering numbering(joints, bodies);
    for (JointIsland& island : found.islands) {
        if (before.takeOver(island)) continue;
        numbering.number(island, found.layouts);
        before.keepState(island);
        for (const JointIndex joint : island.joints) joints[joint].edited = false;
    }
    groupAlike(found);
}

}  // namespace plumb
