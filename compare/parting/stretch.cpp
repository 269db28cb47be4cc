// SPDX-License-Identifier: MIT
#include <compare/parting/stretch.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace plumb::compare {
namespace {

using Links = std::map<std::size_t, std::vector<std::size_t>>;  // for each body, those that it is joined to or touches

bool isFreeToMove(const Scene& scene, std::size_t body) {
    return scene.bodies[body].def.type == BodyType::Dynamic;
}

void link(Links& links, std::size_t a, std::size_t b) {
    links[a].push_back(b);
    links[b].push_back(a);
}

/// Links the bodies of each joint; of a gear, those of the joints that it couples.
Links linksBy(const JointStates& joints) {
    Links links;
    for (std::size_t joint = 0; joint < joints.joints().size(); ++joint) {
        const std::vector<std::size_t> held = bodiesOf(joints.joints(), joint);
        for (std::size_t i = 1; i < held.size(); ++i) link(links, held[i - 1], held[i]);
    }
    return links;
}

using Touches = std::set<std::pair<std::size_t, std::size_t>>;

/// What touches in one of the two runs when the body parts.
Touches touchesOf(const Parted& parted, const Touching& touching) {
    Touches touches = touching.pairs(parted.a.states[parted.tick]);
    touches.merge(touching.pairs(parted.b.states[parted.tick]));
    return touches;
}

Links linksBy(const JointStates& joints, const Touches& touches) {
    Links links = linksBy(joints);
    for (const auto& [first, second] : touches) link(links, first, second);
    return links;
}

/// The bodies that can be reached from `from`, the nearest first. A body that is not free to move ends a way.
struct Search {
    std::vector<std::size_t> reached;
    std::map<std::size_t, std::size_t> cameFrom;
};
Search searchFrom(std::size_t from, const Scene& scene, const Links& links) {
    Search search{{from}, {{from, from}}};
    for (std::size_t i = 0; i < search.reached.size(); ++i) {
        const std::size_t body = search.reached[i];
        const auto found = links.find(body);
        if (!isFreeToMove(scene, body) || found == links.end()) continue;
        for (const std::size_t other : found->second)
            if (search.cameFrom.try_emplace(other, body).second) search.reached.push_back(other);
    }
    return search;
}

/// The bodies from `from` to the nearest one that is not free to move, both included. If there is none, to the farthest
/// one.
std::vector<std::size_t> wayToGround(const Scene& scene, const Links& links, std::size_t from) {
    const Search search = searchFrom(from, scene, links);
    const auto ground =
        std::ranges::find_if(search.reached, [&](std::size_t body) { return !isFreeToMove(scene, body); });
    std::vector<std::size_t> way{ground == search.reached.end() ? search.reached.back() : *ground};
    while (way.back() != from) way.push_back(search.cameFrom.at(way.back()));
    return way;
}

/// The places of the joints that hold the body, or a free body that can be reached from it over the links.
std::vector<std::size_t> jointsAround(const Parted& parted, const JointStates& joints, const Links& links) {
    const Search search = searchFrom(parted.body, parted.scene, links);
    const auto isHere = [&](std::size_t body) {
        return isFreeToMove(parted.scene, body) && search.cameFrom.contains(body);
    };
    std::vector<std::size_t> found;
    for (std::size_t joint = 0; joint < joints.joints().size(); ++joint)
        if (std::ranges::any_of(bodiesOf(joints.joints(), joint), isHere)) found.push_back(joint);
    return found;
}

bool isSeen(const JointStates& joints, std::size_t joint, const Observation& run, std::size_t tick) {
    const Broken broken = brokenBy(run, tick);
    return !(joint < broken.size() && broken[joint]) && joints.isPresent(joint, run.states[tick]) &&
           joints.isKnown(joint, run.states[tick]);
}

/// The tick before the step in which the centre of a body goes through an obstacle for the first time.
std::optional<std::size_t> crossedAt(const Parted& parted, const Observation& run, const Touching& touching,
                                     std::size_t body, std::size_t obstacle) {
    for (std::size_t tick = 0; tick + 1 < run.states.size(); ++tick) {
        const BodyState &now = run.states[tick][body], &next = run.states[tick + 1][body];
        if (!now.present || !isFinite(now) || !isFinite(next)) continue;
        const Vec2 to = now.position + parted.scene.wrap.shortest(now.position, next.position);
        if (touching.isCrossed(obstacle, body, run.states[tick], now.position, to)) return tick;
    }
    return {};
}

}  // namespace

std::optional<Crossing> firstPassed(const Parted& parted, const JointStates& joints, const Touching& touching) {
    const Search held = searchFrom(parted.body, parted.scene, linksBy(joints));
    for (const auto& [first, second] : touchesOf(parted, touching))
        for (const auto& [body, obstacle] : {std::pair(first, second), std::pair(second, first)}) {
            if (!held.cameFrom.contains(body) || !isFreeToMove(parted.scene, body)) continue;
            if (isFreeToMove(parted.scene, obstacle)) continue;
            const auto a = crossedAt(parted, parted.a, touching, body, obstacle);
            const auto b = crossedAt(parted, parted.b, touching, body, obstacle);
            if (a.has_value() != b.has_value()) return Crossing{body, obstacle, a.has_value(), a ? *a : *b};
        }
    return {};
}

std::optional<Widest> widestGap(const Parted& parted, const JointStates& joints) {
    std::optional<Widest> widest;
    double sum = 0;
    for (const std::size_t joint : jointsAround(parted, joints, linksBy(joints))) {
        double most = -1;
        for (std::size_t tick = 0; tick <= parted.tick; ++tick) {
            if (!isSeen(joints, joint, parted.a, tick) || !isSeen(joints, joint, parted.b, tick)) continue;
            const double a = joints.gap(joint, parted.a.states[tick]), b = joints.gap(joint, parted.b.states[tick]);
            most = std::max(most, std::abs(a - b));
            if (widest && std::abs(a - b) <= std::abs(widest->valueA - widest->valueB)) continue;
            widest = Widest{.joint = joint, .valueA = a, .valueB = b, .tick = tick};
        }
        sum += std::max(most, 0.0);
    }
    if (widest) widest->together = sum;
    return widest;
}

std::optional<Widest> firstBreak(const Parted& parted, const JointStates& joints, const Touching& touching) {
    const auto brokenAt = [&](const Observation& run, std::size_t joint) {
        const std::optional<std::size_t> tick = joint < run.brokenAt.size() ? run.brokenAt[joint] : std::nullopt;
        return tick && *tick <= parted.tick ? tick : std::nullopt;
    };
    std::optional<Widest> first;
    for (const std::size_t joint : jointsAround(parted, joints, linksBy(joints, touchesOf(parted, touching)))) {
        const std::optional<std::size_t> a = brokenAt(parted.a, joint), b = brokenAt(parted.b, joint);
        if (a.has_value() == b.has_value()) continue;
        const std::size_t tick = a ? *a : *b;
        if (!first || tick < first->tick)
            first = Widest{.joint = joint, .valueA = a ? 1.0 : 0.0, .valueB = b ? 1.0 : 0.0, .tick = tick};
    }
    return first;
}

std::optional<Widest> deepestOverlap(const Parted& parted, const JointStates& joints, const Touching& touching) {
    const std::vector<BodyState>& a = parted.a.states[parted.tick];
    const std::vector<BodyState>& b = parted.b.states[parted.tick];
    const Touches touches = touchesOf(parted, touching);
    std::optional<Widest> deepest;
    double sum = 0;
    const std::vector<std::size_t> way = wayToGround(parted.scene, linksBy(joints, touches), parted.body);
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
        const auto pair = std::minmax(way[i], way[i + 1]);
        if (!touches.contains(pair)) continue;
        const double inA = -touching.separation(pair.first, pair.second, a);
        const double inB = -touching.separation(pair.first, pair.second, b);
        if (std::min(inA, inB) < -Touching::skin) continue;  // they do not touch in one of the runs
        sum += std::abs(inA - inB);
        if (deepest && std::abs(inA - inB) <= std::abs(deepest->valueA - deepest->valueB)) continue;
        deepest = Widest{.bodyA = way[i + 1], .bodyB = way[i], .valueA = inA, .valueB = inB, .tick = parted.tick};
    }
    if (deepest) deepest->together = sum;
    return deepest;
}

}  // namespace plumb::compare
