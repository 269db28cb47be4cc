// SPDX-License-Identifier: MIT
#include <compare/metric/observation.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include <compare/engine/joint_geometry.h>

namespace plumb::compare {
namespace {

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) return *middle;
    return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

/// What the simulation says of forces, and the angles out of the states.
std::vector<double> probeRow(const Scene& scene, const Simulation& simulation, const std::vector<BodyState>& states) {
    std::vector<double> row = simulation.probeValues();
    for (std::size_t i = 0; i < scene.probes.size(); ++i)
        if (const auto* angle = std::get_if<AngleProbe>(&scene.probes[i].quantity))
            row[i] = states[bodyIndex(scene, angle->body)].angle;
    return row;
}

void look(const Scene& scene, const Simulation& simulation, Observation& seen) {
    seen.states.push_back(simulation.states());
    seen.probes.push_back(probeRow(scene, simulation, seen.states.back()));
}

}  // namespace

Observation observe(const Scene& scene, const Engine& engine) {
    Observation seen;
    seen.engine = engine.name;
    seen.version = engine.version;
    seen.settings = engine.settings(scene);
    seen.partial = engine.name == closedFormName;
    seen.dt = scene.dt;
    std::unique_ptr<Simulation> simulation;
    try {
        simulation = engine.build(scene);
    } catch (const Unsupported& reason) {
        seen.unsupported = reason.what();
        return seen;
    }
    look(scene, *simulation, seen);
    std::vector<double> milliseconds;
    for (int step = 0; step < stepCount(scene); ++step) {
        const auto start = std::chrono::steady_clock::now();
        simulation->step(scene.dt);
        const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
        milliseconds.push_back(taken.count());
        look(scene, *simulation, seen);
    }
    if (!seen.partial && !milliseconds.empty()) seen.msPerStep = median(std::move(milliseconds));
    return seen;
}

bool isFinite(const BodyState& state) {
    return state.position.allFinite() && state.velocity.allFinite() && std::isfinite(state.angle) &&
           std::isfinite(state.angularVelocity);
}

}  // namespace plumb::compare
