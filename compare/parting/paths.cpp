// SPDX-License-Identifier: MIT
#include <compare/parting/paths.h>

#include <algorithm>
#include <cmath>

#include <compare/metric/observation.h>

namespace plumb::compare {
namespace {

bool mayPart(const SceneBody& body) {
    return body.def.type != BodyType::Static && body.def.enabled;
}

/// An engine that may leave bodies out may also leave out their angles.
bool isSaid(const Observation& run, const BodyState& state) {
    return run.partial ? state.position.allFinite() && state.velocity.allFinite() : isFinite(state);
}

bool isThere(const Observation& run, std::size_t body, std::size_t tick) {
    return tick < run.states.size() && run.states[tick][body].present && isSaid(run, run.states[tick][body]);
}

}  // namespace

Vec2 Paths::wayAt(std::size_t tick) const {
    const double lost = lostAt(tick);
    if (std::isnan(lost) || lost > 0) return {lost, lost};
    return between(a_, tick, b_, tick);
}

Vec2 Paths::offsetAt(std::size_t tick) const {
    const double lost = lostAt(tick);
    if (std::isnan(lost) || lost > 0) return {lost, lost};
    const Vec2 ofA = toPath(a_, b_, tick), ofB = -toPath(b_, a_, tick);
    return ofA.squaredNorm() <= ofB.squaredNorm() ? ofA : ofB;
}

double Paths::lostAt(std::size_t tick) const {
    const BodyState &inA = a_.states[tick][body_], &inB = b_.states[tick][body_];
    const bool saidA = isSaid(a_, inA), saidB = isSaid(b_, inB);
    if (!inA.present || !inB.present || (!saidA && a_.partial) || (!saidB && b_.partial)) return unsaid;
    return saidA && saidB ? 0 : unbounded;
}

Vec2 Paths::between(const Observation& of, std::size_t tick, const Observation& from, std::size_t fromTick) const {
    return wrap_.shortest(from.states[fromTick][body_].position, of.states[tick][body_].position);
}

Vec2 Paths::toPath(const Observation& of, const Observation& path, std::size_t tick) const {
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

std::vector<std::size_t> movingBodies(const Scene& scene) {
    std::vector<std::size_t> moving;
    for (std::size_t body = 0; body < scene.bodies.size(); ++body)
        if (mayPart(scene.bodies[body])) moving.push_back(body);
    return moving;
}

std::size_t ticksOf(const Observation& a, const Observation& b) {
    return std::min(a.states.size(), b.states.size());
}

}  // namespace plumb::compare
