// SPDX-License-Identifier: MIT
#include <compare/metric/probe_error.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <compare/engine/joint_geometry.h>

namespace plumb::compare {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// The tick from which on the probe is watched: the first at or after its time, up to rounding.
std::size_t firstTick(const Probe& probe, double dt) {
    constexpr double slack = 1e-9;  // of a step
    return static_cast<std::size_t>(std::max(0.0, std::ceil(probe.from / dt - slack)));
}

std::optional<double> worse(std::optional<double> worst, double error) {
    return std::max(worst.value_or(error), error);
}

std::optional<double> angleError(const Observation& run, const Observation& truth, std::size_t body, std::size_t from) {
    std::optional<double> worst;
    for (std::size_t tick = from; tick < std::min(run.states.size(), truth.states.size()); ++tick) {
        const double expected = truth.states[tick][body].angle;
        const double angle = run.states[tick][body].angle;
        if (std::isnan(expected)) continue;
        const bool lost = !std::isfinite(angle);
        if (lost && run.partial) continue;
        worst = worse(worst, lost ? unbounded : std::abs(angle - expected));
    }
    return worst;
}

}  // namespace

std::optional<double> probeError(const Scene& scene, std::size_t index, const Observation& run,
                                 const Observation* truth) {
    const Probe& probe = scene.probes[index];
    const std::size_t from = firstTick(probe, run.dt);
    const auto* angle = std::get_if<AngleProbe>(&probe.quantity);
    if (angle && truth && from < truth->states.size()) {
        const std::size_t body = bodyIndex(scene, angle->body);
        if (!std::isnan(truth->states[from][body].angle)) return angleError(run, *truth, body, from);
    }
    std::optional<double> worst;
    for (std::size_t tick = from; tick < run.probes.size(); ++tick) {
        const double value = run.probes[tick][index];
        // A force that is NaN is one the engine does not know; an angle that is NaN is a body gone astray.
        if (std::isnan(value) && (!angle || run.partial)) continue;
        worst = worse(worst, std::isfinite(value) ? std::abs(value - probe.expected) : unbounded);
    }
    return worst;
}

}  // namespace plumb::compare
