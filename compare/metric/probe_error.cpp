// SPDX-License-Identifier: MIT
#include <compare/metric/metrics.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <compare/metric/observation.h>
#include <compare/scene/joint_geometry.h>

namespace plumb::compare {
namespace {

/// Ticks from the first at or after the probe's start to the last at or before its end, up to rounding.
struct Window {
    std::size_t first, end;
};

Window windowOf(const Probe& probe, double dt, std::size_t ticks) {
    constexpr double slack = 1e-9;  // of a step
    const double first = std::max(0.0, std::ceil(probe.from / dt - slack));
    const double end = probe.until > 0 ? std::floor(probe.until / dt + slack) + 1 : static_cast<double>(ticks);
    return {static_cast<std::size_t>(first), static_cast<std::size_t>(std::min(end, static_cast<double>(ticks)))};
}

/// Two values of one tick.
struct Pair {
    double value, expected;
};

/// Those that count.
std::vector<Pair> watched(std::vector<Pair> pairs, Watch watch) {
    if (watch == Watch::Every || pairs.size() < 2) return pairs;
    if (watch == Watch::Last) return {pairs.back()};
    const auto size = [](double value) { return std::isfinite(value) ? std::abs(value) : unbounded; };
    Pair largest = pairs.front();  // each on its own: they need not come at the same tick
    for (const Pair& pair : pairs) {
        if (size(pair.value) > size(largest.value)) largest.value = pair.value;
        if (size(pair.expected) > size(largest.expected)) largest.expected = pair.expected;
    }
    return {largest};
}

std::optional<double> worst(const std::vector<Pair>& pairs) {
    std::optional<double> result;
    for (const Pair& pair : pairs) {
        const double error = std::isfinite(pair.value) ? std::abs(pair.value - pair.expected) : unbounded;
        result = std::max(result.value_or(error), error);
    }
    return result;
}

}  // namespace

std::optional<double> probeError(const Scene& scene, std::size_t index, const Observation& run,
                                 const Observation* truth) {
    const Probe& probe = scene.probes[index];
    const Window window = windowOf(probe, run.dt, run.probes.size());
    const auto* angle = std::get_if<AngleProbe>(&probe.quantity);
    const auto expectedAt = [&, body = angle ? bodyIndex(scene, angle->body) : 0](std::size_t tick) {
        return truth && tick < truth->states.size() ? truth->states[tick][body].angle : unsaid;
    };
    const bool byTruth = angle && !std::isnan(expectedAt(window.first));
    std::vector<Pair> pairs;
    for (std::size_t tick = window.first; tick < window.end; ++tick) {
        const double value = run.probes[tick][index];
        const double expected = byTruth ? expectedAt(tick) : probe.expected;
        // Where an engine gives no number, it does not know the value. For what is read from the states, such as an
        // angle, it is a body that it has lost.
        const bool unknown = std::isnan(value) && (!isSeen(probe) || run.partial);
        if (!unknown && !std::isnan(expected)) pairs.push_back({value, expected});
    }
    return worst(watched(std::move(pairs), probe.watch));
}

}  // namespace plumb::compare
