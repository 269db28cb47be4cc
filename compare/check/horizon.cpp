// SPDX-License-Identifier: MIT
#include <compare/check/horizon.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <compare/metric/length_text.h>
#include <compare/parting/paths.h>

namespace plumb::compare {
namespace {

constexpr double seen = 0.01;       // as for partings: less is no other path [m]
constexpr double helps = 0.7;       // with at most this part of the difference left, halving the step helps [-]
constexpr double roundings = 1e-9;  // differences below are rounding, also in single precision at this size [m]

/// The run at a part of the step, seen only at the ticks of the whole step.
Observation finer(const Scene& scene, const Engine& engine, int parts) {
    Scene divided = scene;
    divided.dt /= parts;
    Observation run = observe(divided, engine);
    std::vector<std::vector<BodyState>> kept;
    for (std::size_t tick = 0; tick < run.states.size(); tick += static_cast<std::size_t>(parts))
        kept.push_back(std::move(run.states[tick]));
    run.states = std::move(kept);
    run.dt = scene.dt;
    return run;
}

/// For each tick, the largest distance so far of a body from its path in the other run.
std::vector<double> farthest(const Scene& scene, const Observation& a, const Observation& b) {
    std::vector<double> most;
    for (std::size_t tick = 0; tick < ticksOf(a, b); ++tick) {
        double here = most.empty() ? 0 : most.back();
        for (const std::size_t body : movingBodies(scene))
            if (const double off = Paths(scene, a, b, body).offsetAt(tick).norm(); off > here) here = off;
        most.push_back(here);
    }
    return most;
}

/// The part of a difference that is left when the step is halved; none of a difference that nobody could find.
double leftOf(double before, double after) {
    return std::isfinite(before) && std::isfinite(after) && before > 0 ? after / before : after > seen ? 1 : 0;
}

}  // namespace

OwnSteps ownSteps(const Scene& scene, const Engine& engine, const Observation& run) {
    OwnSteps steps{.engine = engine.name};
    if (run.states.empty()) return steps;
    const Observation half = finer(scene, engine, 2), quarter = finer(scene, engine, 4);
    const std::vector<double> first = farthest(scene, run, half), second = farthest(scene, half, quarter);
    steps.halved = first.back();
    double left = leftOf(first.back(), second.back());
    // Far apart, they may have come nearer by chance: an eighth tells.
    if (second.back() > seen && left <= helps)
        left = std::max(left, leftOf(second.back(), farthest(scene, quarter, finer(scene, engine, 8)).back()));
    if (second.back() > roundings && std::isfinite(left) && left > 0) steps.order = -std::log2(left);
    if (!(left > helps)) return steps;
    for (std::size_t tick = 0; tick < std::min(first.size(), second.size()) && !steps.horizon; ++tick)
        if (std::min(first[tick], second[tick]) > seen) steps.horizon = static_cast<double>(tick) * scene.dt;
    return steps;
}

std::string ownStepsText(const OwnSteps& steps) {
    if (steps.horizon)
        return fmt::format(
            "{}: from {:.3g} s on, half and a quarter of the step are over 1 cm apart, and do not come nearer to each "
            "other than to the whole step: what differs later decides nothing.",
            steps.engine, *steps.horizon);
    if (!(steps.halved > seen) || !steps.order) return "";
    return fmt::format("{}: half the step puts a body {} beside its path; order {:.2g}.", steps.engine,
                       lengthText(steps.halved), *steps.order);
}

}  // namespace plumb::compare
