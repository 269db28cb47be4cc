// SPDX-License-Identifier: MIT
#include <compare/parting/parting.h>

#include <algorithm>
#include <cmath>

#include <compare/metric/observation.h>
#include <compare/parting/cause.h>
#include <compare/parting/paths.h>
#include <compare/parting/touching.h>

namespace plumb::compare {
namespace {

constexpr double limits[] = {0.01, 0.04, 0.16};  // if engines keep bodies apart, the next limit is tried [m]
constexpr double farPart = 0.1;                  // of the distance at the end: the limit of a second parting [-]
constexpr double farTimes = 10;                  // that limit must be at least so many times the first one [-]
constexpr double leastSkin = 2e-3;               // no engine sets a smaller gap on purpose [m]

/// Of some bodies, the one that parts first. Of those that part at the same tick, the one that is farthest away.
std::optional<Parted> firstParted(const Scene& scene, const Observation& a, const Observation& b,
                                  std::span<const std::size_t> bodies, double limit) {
    for (std::size_t tick = 1; tick < ticksOf(a, b); ++tick) {
        std::optional<Parted> first;
        double most = limit;
        for (const std::size_t body : bodies) {
            const Vec2 offset = Paths(scene, a, b, body).offsetAt(tick);
            if (!(offset.norm() > most)) continue;
            most = offset.norm();
            first.emplace(Parted{scene, a, b, body, tick, offset});
        }
        if (first) return first;
    }
    return {};
}

/// The distance at the last tick at which both runs have the body.
double apartAtEnd(const Scene& scene, const Observation& a, const Observation& b, std::size_t body) {
    for (std::size_t tick = ticksOf(a, b); tick-- > 0;)
        if (const double apart = Paths(scene, a, b, body).wayAt(tick).norm(); !std::isnan(apart)) return apart;
    return 0;
}

double mostOff(const Scene& scene, const Observation& a, const Observation& b) {
    double most = 0;
    for (const std::size_t body : movingBodies(scene))
        for (std::size_t tick = 0; tick < ticksOf(a, b); ++tick)
            if (const double off = Paths(scene, a, b, body).offsetAt(tick).norm(); off > most) most = off;
    return most;
}

/// Of runs that do not part, who is late most.
Late latest(const Scene& scene, const Observation& a, const Observation& b) {
    Late late;
    for (const std::size_t body : movingBodies(scene))
        for (std::size_t tick = 0; tick < ticksOf(a, b); ++tick) {
            const Vec2 way = Paths(scene, a, b, body).wayAt(tick);
            if (!(way.norm() > late.distance)) continue;
            const bool isAhead = way.dot(a.states[tick][body].velocity + b.states[tick][body].velocity) > 0;
            late = {isAhead ? b.engine : a.engine, scene.bodies[body].name, way.norm()};
        }
    return late;
}

/// What the distance at the last tick that both runs have the body is made of.
std::vector<Portion> portionsAtEnd(const Scene& scene, const Observation& a, const Observation& b, std::size_t body) {
    std::size_t tick = ticksOf(a, b) - 1;
    while (tick > 0 && std::isnan(Paths(scene, a, b, body).wayAt(tick).norm())) --tick;
    const Parted parted{scene, a, b, body, tick, Paths(scene, a, b, body).wayAt(tick)};
    std::vector<Portion> portions;
    if (isTrack(a) || isTrack(b)) return portions;
    if (tick == 0 || !std::isfinite(parted.offset.norm()) || parted.offset.isZero(0)) return portions;
    for (const Share& share : sharesOf(parted, JointStates(scene), Touching(scene))) {
        const bool isTouch = share.agent == Agent::Across || share.agent == Agent::Along;
        portions.push_back(
            {share.agent, isTouch ? scene.bodies[share.other].name : "", share.length / parted.offset.norm()});
    }
    return portions;
}

std::optional<Parting> partingBeyond(const Scene& scene, const Observation& a, const Observation& b,
                                     std::span<const std::size_t> bodies, double limit) {
    const std::optional<Parted> first = firstParted(scene, a, b, bodies, limit);
    if (!first) return {};
    Parting parting{.engineA = a.engine, .engineB = b.engine, .body = scene.bodies[first->body].name, .limit = limit};
    parting.time = static_cast<double>(first->tick) * a.dt;
    parting.apart = apartAtEnd(scene, a, b, first->body);
    addCause(*first, parting);
    return parting;
}

Parting partingOf(const Scene& scene, const Observation& a, const Observation& b) {
    const std::vector<std::size_t> moving = movingBodies(scene);
    std::optional<Parting> first;
    for (const double limit : limits) {
        const std::optional<Parting> parting = partingBeyond(scene, a, b, moving, limit);
        if (!parting) break;
        if (!first || !isSkin(*parting)) first = parting;
        if (!isSkin(*parting)) break;
    }
    if (first) return *first;
    Parting together{.engineA = a.engine, .engineB = b.engine, .limit = limits[0], .apart = mostOff(scene, a, b)};
    together.late = latest(scene, a, b);
    return together;
}

/// Why the body that is farthest away at the end is off its path by a tenth of that distance. Empty if no body is much
/// farther away than at the first parting, or if the cause is the same.
std::optional<Parting> laterParting(const Scene& scene, const Observation& a, const Observation& b,
                                    const Parting& first) {
    std::size_t farthest = 0;
    double most = 0;
    for (const std::size_t body : movingBodies(scene)) {
        const double apart = apartAtEnd(scene, a, b, body);
        if (!(apart > most)) continue;
        most = apart;
        farthest = body;
    }
    const double limit = farPart * most;
    if (std::isinf(limit) || limit < farTimes * first.limit) return {};
    std::optional<Parting> later = partingBeyond(scene, a, b, std::span(&farthest, 1), limit);
    if (later && later->quantity == first.quantity && later->at == first.at) later.reset();
    return later;
}

void addPartings(const Scene& scene, const Observation& a, const Observation& b, std::vector<Parting>& partings) {
    const Parting first = partingOf(scene, a, b);
    partings.push_back(first);
    if (first.body.empty()) return;
    if (const std::optional<Parting> later = laterParting(scene, a, b, first)) partings.push_back(*later);
}

}  // namespace

bool isSkin(const Parting& parting) {
    const double gap = -std::min(parting.valueA, parting.valueB);
    return parting.quantity == Difference::Overlap && gap > leastSkin && gap <= Touching::skin;
}

std::vector<Parting> partingsOf(const Scene& scene, std::span<const Observation* const> runs) {
    std::vector<Parting> partings;
    for (std::size_t i = 0; i < runs.size(); ++i)
        for (std::size_t j = i + 1; j < runs.size(); ++j)
            if (!runs[i]->states.empty() && !runs[j]->states.empty()) addPartings(scene, *runs[i], *runs[j], partings);
    return partings;
}

void addPortions(const Scene& scene, std::span<const Observation* const> runs, std::vector<Parting>& partings) {
    const auto runIn = [&](const std::string& engine) -> const Observation& {
        return **std::ranges::find(runs, engine, [](const Observation* run) { return run->engine; });
    };
    for (Parting& parting : partings) {
        const auto body = std::ranges::find(scene.bodies, parting.body, &SceneBody::name);
        if (body == scene.bodies.end()) continue;
        parting.portions = portionsAtEnd(scene, runIn(parting.engineA), runIn(parting.engineB),
                                         static_cast<std::size_t>(body - scene.bodies.begin()));
    }
}

}  // namespace plumb::compare
