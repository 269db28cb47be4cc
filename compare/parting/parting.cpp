// SPDX-License-Identifier: MIT
#include <compare/parting/parting.h>

#include <algorithm>
#include <cmath>

#include <compare/metric/missing.h>
#include <compare/parting/cause.h>
#include <compare/parting/touching.h>

namespace plumb::compare {
namespace {

constexpr double limits[] = {0.01, 0.04, 0.16};  // if engines keep bodies apart, the next limit is tried [m]
constexpr double farPart = 0.1;                  // of the distance at the end: the limit of a second parting [-]
constexpr double farTimes = 10;                  // that limit must be at least so many times the first one [-]
constexpr double leastSkin = 2e-3;               // no engine sets a smaller gap on purpose [m]

bool mayPart(const SceneBody& body) {
    return body.def.type != BodyType::Static && body.def.enabled;
}

bool isThere(const Observation& run, std::size_t body, std::size_t tick) {
    return tick < run.states.size() && run.states[tick][body].present && isFinite(run.states[tick][body]);
}

/// Two runs of a body. A result is NaN if one run does not describe the body, or does not have it yet; infinite if a
/// run has lost it.
class Paths {
public:
    Paths(const Scene& scene, const Observation& a, const Observation& b, std::size_t body)
        : wrap_(scene.wrap), a_(a), b_(b), body_(body) {}

    /// The distance between the two at one moment [m].
    double apartAt(std::size_t tick) const {
        const double lost = lostAt(tick);
        return std::isnan(lost) || lost > 0 ? lost : between(a_, tick, b_, tick).norm();
    }

    /// From the path of one run, within a step before and after, to the place of the body in the other; the shorter of
    /// both ways [m].
    Vec2 offsetAt(std::size_t tick) const {
        const double lost = lostAt(tick);
        if (std::isnan(lost) || lost > 0) return {lost, lost};
        const Vec2 ofA = toPath(a_, b_, tick), ofB = -toPath(b_, a_, tick);
        return ofA.squaredNorm() <= ofB.squaredNorm() ? ofA : ofB;
    }

private:
    double lostAt(std::size_t tick) const {
        const BodyState &inA = a_.states[tick][body_], &inB = b_.states[tick][body_];
        const bool saidA = isFinite(inA), saidB = isFinite(inB);
        if (!inA.present || !inB.present || (!saidA && a_.partial) || (!saidB && b_.partial)) return unsaid;
        return saidA && saidB ? 0 : unbounded;
    }

    Vec2 between(const Observation& of, std::size_t tick, const Observation& from, std::size_t fromTick) const {
        return wrap_.shortest(from.states[fromTick][body_].position, of.states[tick][body_].position);
    }

    Vec2 toPath(const Observation& of, const Observation& path, std::size_t tick) const {
        const Vec2 here = between(of, tick, path, tick);
        Vec2 best = here;
        for (const std::size_t end : {tick - 1, tick + 1}) {
            if (!isThere(path, body_, end)) continue;
            const Vec2 way = between(path, end, path, tick);
            const double part = way.isZero(0) ? 0 : std::clamp(here.dot(way) / way.squaredNorm(), 0.0, 1.0);
            const Vec2 rest = here - part * way;
            if (rest.squaredNorm() < best.squaredNorm()) best = rest;
        }
        return best;
    }

    const Wrap& wrap_;
    const Observation &a_, &b_;
    std::size_t body_;
};

std::size_t ticksOf(const Observation& a, const Observation& b) {
    return std::min(a.states.size(), b.states.size());
}

std::vector<std::size_t> movingBodies(const Scene& scene) {
    std::vector<std::size_t> moving;
    for (std::size_t body = 0; body < scene.bodies.size(); ++body)
        if (mayPart(scene.bodies[body])) moving.push_back(body);
    return moving;
}

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
        if (const double apart = Paths(scene, a, b, body).apartAt(tick); !std::isnan(apart)) return apart;
    return 0;
}

double mostOff(const Scene& scene, const Observation& a, const Observation& b) {
    double most = 0;
    for (const std::size_t body : movingBodies(scene))
        for (std::size_t tick = 0; tick < ticksOf(a, b); ++tick)
            if (const double off = Paths(scene, a, b, body).offsetAt(tick).norm(); off > most) most = off;
    return most;
}

/// True if the only difference is that one engine keeps touching bodies apart.
bool isSkin(const Parting& parting) {
    const double gap = -std::min(parting.valueA, parting.valueB);
    return parting.quantity == Difference::Overlap && gap > leastSkin && gap <= Touching::skin;
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
    return {.engineA = a.engine, .engineB = b.engine, .limit = limits[0], .apart = mostOff(scene, a, b)};
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

std::vector<Parting> partingsOf(const Scene& scene, std::span<const Observation* const> runs) {
    std::vector<Parting> partings;
    for (std::size_t i = 0; i < runs.size(); ++i)
        for (std::size_t j = i + 1; j < runs.size(); ++j)
            if (!runs[i]->states.empty() && !runs[j]->states.empty()) addPartings(scene, *runs[i], *runs[j], partings);
    return partings;
}

}  // namespace plumb::compare
