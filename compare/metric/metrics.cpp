// SPDX-License-Identifier: MIT
#include <compare/metric/metrics.h>

#include <algorithm>
#include <cmath>

#include <compare/metric/geometry.h>
#include <compare/metric/mechanics.h>
#include <compare/metric/observation.h>

namespace plumb::compare {
namespace {

constexpr double divergenceLimit = 0.01;  // [m]
constexpr double settledSpeed = 0.05;     // [m/s]

/// The largest distance of the given bodies at one tick. Where one of the two places is not a number, the distance is
/// infinite; where that run may leave bodies out, the body is skipped.
double farthest(const std::vector<std::size_t>& bodies, const std::vector<BodyState>& of, bool ofMayBeSilent,
                const std::vector<BodyState>& from, bool fromMayBeSilent) {
    double worst = unsaid;
    for (const std::size_t body : bodies) {
        const bool ofSaid = of[body].position.allFinite();
        const bool fromSaid = from[body].position.allFinite();
        if ((!ofSaid && ofMayBeSilent) || (!fromSaid && fromMayBeSilent)) continue;
        const double apart = ofSaid && fromSaid ? (of[body].position - from[body].position).norm() : unbounded;
        worst = std::isnan(worst) ? apart : std::max(worst, apart);
    }
    return worst;
}

std::vector<double> distances(const std::vector<std::size_t>& bodies, const Observation& of, const Observation& from) {
    std::vector<double> result;
    const std::size_t ticks = std::min(of.states.size(), from.states.size());
    for (std::size_t tick = 0; tick < ticks; ++tick)
        result.push_back(farthest(bodies, of.states[tick], of.partial, from.states[tick], from.partial));
    return result;
}

std::optional<double> largest(const std::vector<double>& series) {
    std::optional<double> result;
    for (const double value : series)
        if (!std::isnan(value)) result = std::max(result.value_or(value), value);
    return result;
}

std::optional<double> lastSaid(const std::vector<double>& series) {
    const auto said = std::find_if(series.rbegin(), series.rend(), [](double value) { return !std::isnan(value); });
    if (said == series.rend()) return {};
    return *said;
}

std::optional<double> firstTimeOver(const std::vector<double>& series, double limit, double dt) {
    const auto over = std::find_if(series.begin(), series.end(), [&](double value) { return value > limit; });
    if (over == series.end()) return {};
    return static_cast<double>(over - series.begin()) * dt;
}

/// How far the quantities of a run stray from their start, and the sizes they are measured by.
struct Drifts {
    double energy = 0, momentum = 0, angularMomentum = 0;
    double kinetic = 0, lowest = 0, highest = 0, momentumSize = 0, angularMomentumSize = 0;
    bool lost = false;  // a state was not a number

    void add(const Mechanics& start, const Mechanics& now) {
        const double stored = (now.lifted - start.lifted) + (now.elastic - start.elastic) + (now.field - start.field);
        energy = std::max(energy, std::abs((now.kinetic - start.kinetic) + stored));
        momentum = std::max(momentum, (now.momentum - start.momentum).norm());
        angularMomentum = std::max(angularMomentum, std::abs(now.angularMomentum - start.angularMomentum));
        kinetic = std::max(kinetic, now.kinetic);
        lowest = std::min(lowest, stored);
        highest = std::max(highest, stored);
        momentumSize = std::max(momentumSize, now.momentumSize);
        angularMomentumSize = std::max(angularMomentumSize, now.angularMomentumSize);
    }
    double relative(double drift, double size) const {
        if (lost) return unbounded;
        return drift == 0 ? 0 : drift / size;
    }
};

/// lost: the energy of a tick with a state that is not a number.
void addEnergies(const std::optional<Mechanics>& now, double lost, Series& series) {
    const Mechanics sums = now.value_or(Mechanics());
    const std::array<double, energyKinds.size()> kinds{sums.kinetic, sums.potential, sums.elastic, sums.field};
    double all = 0;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        all += kinds[i];
        series.energies[i].push_back(now ? kinds[i] : unsaid);
    }
    series.energy.push_back(now ? all : lost);
}

void measureMechanics(const Scene& scene, const MassModel& masses, const Observation& run, Measured& measured) {
    if (!masses.anyDynamic()) return;
    std::optional<Mechanics> start;
    Drifts drifts;
    for (std::size_t tick = 0; tick < run.states.size(); ++tick) {
        const std::optional<Mechanics> now = masses.at(run.states[tick], brokenBy(run, tick));
        addEnergies(now, run.partial ? unsaid : unbounded, measured.series);
        if (!start) start = now;
        if (now) drifts.add(*start, *now);
        if (!now && !run.partial) drifts.lost = true;
    }
    if (!start && !drifts.lost) {  // the closed form does not give every dynamic body
        measured.series.energy.clear();
        measured.series.energies = {};
        return;
    }
    if (!std::ranges::all_of(scene.bodies, isAlwaysThere)) return;  // what comes brings energy
    const double energy = std::max(drifts.kinetic, drifts.highest - drifts.lowest);
    measured.metrics["energy_drift"] = drifts.relative(drifts.energy, energy);
    measured.metrics["momentum_drift"] = drifts.relative(drifts.momentum, drifts.momentumSize);
    measured.metrics["angular_momentum_drift"] = drifts.relative(drifts.angularMomentum, drifts.angularMomentumSize);
}

std::optional<double> settleTime(const MassModel& masses, const Observation& run) {
    std::size_t settled = run.states.size();  // the first tick of those at the end that are slow
    while (settled > 0 && masses.fastestPoint(run.states[settled - 1]).value_or(unbounded) <= settledSpeed) --settled;
    if (settled == run.states.size()) return {};
    return static_cast<double>(settled) * run.dt;
}

/// The largest over a run of a quantity of a tick; a tick that has none makes it infinite.
template <class Quantity>
double worstOf(const Observation& run, Quantity quantity) {
    double worst = 0;
    for (std::size_t tick = 0; tick < run.states.size(); ++tick)
        worst = std::max(worst, std::optional<double>(quantity(tick)).value_or(unbounded));
    return worst;
}

void measureGeometry(const Scene& scene, const Observation& run, Metrics& metrics) {
    const Geometry geometry(scene);
    if (geometry.anyMayTouch())
        metrics["penetration_max"] =
            worstOf(run, [&](std::size_t tick) { return geometry.penetration(run.states[tick]); });
    if (geometry.anyJoint())
        metrics["joint_error_max"] =
            worstOf(run, [&](std::size_t tick) { return geometry.jointError(run.states[tick], brokenBy(run, tick)); });
}

std::vector<std::size_t> allBodies(const Scene& scene) {
    std::vector<std::size_t> result(scene.bodies.size());
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = i;
    return result;
}

}  // namespace

Measured measure(const Scene& scene, const Observation& run, const Observation* truth, const Observation* reference) {
    Measured measured;
    Metrics& metrics = measured.metrics;
    for (const std::string& name : metricNames(scene)) metrics[name] = {};
    if (run.states.empty()) return measured;
    const MassModel masses(scene);
    if (truth && !truth->states.empty()) {
        measured.series.error = distances(allBodies(scene), run, *truth);
        metrics["error_max"] = largest(measured.series.error);
        metrics["error_end"] = lastSaid(measured.series.error);
    }
    if (reference && !reference->states.empty()) {
        measured.series.divergence = distances(masses.dynamicBodies(), run, *reference);
        metrics["divergence_max"] = largest(measured.series.divergence);
        metrics["divergence_time"] = firstTimeOver(measured.series.divergence, divergenceLimit, run.dt);
    }
    measureMechanics(scene, masses, run, measured);
    if (!run.partial) {
        measureGeometry(scene, run, metrics);
        if (masses.anyDynamic()) metrics["settle_time"] = settleTime(masses, run);
        metrics["ms_per_step"] = run.msPerStep;
    }
    for (std::size_t i = 0; i < scene.probes.size(); ++i)
        metrics["probe." + scene.probes[i].name] = probeError(scene, i, run, truth);
    return measured;
}

std::optional<double> divergenceUntil(const Scene& scene, const Observation& a, const Observation& b, double until) {
    std::vector<double> apart = distances(MassModel(scene).dynamicBodies(), a, b);
    // Half a step of slack: a horizon of whole steps must not lose its last one to rounding.
    const double ticks = std::floor(until / a.dt + 0.5) + 1;
    if (ticks < static_cast<double>(apart.size())) apart.resize(static_cast<std::size_t>(ticks));
    return largest(apart);
}

std::vector<std::string> metricNames(const Scene& scene) {
    std::vector<std::string> names{"error_max",
                                   "error_end",
                                   "divergence_max",
                                   "divergence_time",
                                   "energy_drift",
                                   "momentum_drift",
                                   "angular_momentum_drift",
                                   "penetration_max",
                                   "joint_error_max",
                                   "settle_time",
                                   "ms_per_step"};
    for (const Probe& probe : scene.probes) names.push_back("probe." + probe.name);
    return names;
}

std::string metricUnit(const Scene& scene, const std::string& metric) {
    for (const Probe& probe : scene.probes)
        if (metric == "probe." + probe.name) return probe.unit;
    if (metric == "ms_per_step") return "ms";
    if (metric == "divergence_time" || metric == "settle_time") return "s";
    return metric.ends_with("_drift") ? "" : "m";
}

}  // namespace plumb::compare
