// SPDX-License-Identifier: MIT
#include <compare/report/data.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>

#include <compare/report/curve.h>
#include <compare/report/playback.h>
#include <compare/view/engine_cards.h>
#include <compare/view/result_view.h>
#include <compare/view/scene_view.h>

namespace plumb::compare {
namespace {

using nlohmann::json;

constexpr std::size_t mostForces = 8;  // the forces of so many joints are kept for the page's CSV

json partData(const PackedPart& part) {
    return {part.first, part.count};
}

/// Null if the series does not exist or has no numbers.
json curveData(const std::vector<double>& series, std::size_t stride, PackedBlock& block) {
    const bool empty = std::ranges::all_of(series, [](double value) { return std::isnan(value); });
    return empty ? json() : partData(block.addFloats(thinned(series, stride)));
}

json probeData(const Scene& scene, const Observation& run, std::size_t stride, PackedBlock& block) {
    json curves = json::array();
    for (std::size_t p = 0; p < scene.probes.size(); ++p) {
        std::vector<double> series;
        for (const std::vector<double>& tick : run.probes) series.push_back(tick.at(p));
        curves.push_back(curveData(series, stride, block));
    }
    return curves;
}

/// A name and a curve of each kind of energy that the scene has. Potential energy has none: it is what the others leave
/// of the sum. Nothing if the curves do not keep every tick, because then they have peaks of different ticks.
json energiesData(const Series& series, std::size_t stride, PackedBlock& block) {
    json energies = json::array();
    for (std::size_t i = 0; stride == 1 && i < energyKinds.size(); ++i) {
        const auto isNone = [](double energy) { return energy == 0 || std::isnan(energy); };
        if (std::ranges::all_of(series.energies[i], isNone)) continue;
        const bool isRest = energyKinds[i] == std::string_view("potential");
        energies.push_back({energyKinds[i], isRest ? json() : curveData(series.energies[i], stride, block)});
    }
    return energies;
}

/// A name and a curve of each joint's force. Nothing in scenes of many joints, which would take too much room, or if
/// the curves do not keep every tick.
json forcesData(const Scene& scene, const Observation& run, std::size_t stride, PackedBlock& block) {
    json forces = json::array();
    const bool isKnown = !run.jointForces.empty() && !run.jointForces.front().empty();
    if (!isKnown || stride > 1 || scene.joints.size() > mostForces) return forces;
    for (std::size_t joint = 0; joint < scene.joints.size(); ++joint) {
        std::vector<double> series;
        for (const std::vector<double>& tick : run.jointForces) series.push_back(tick.at(joint));
        forces.push_back({scene.joints[joint].name, curveData(series, stride, block)});
    }
    return forces;
}

/// Adds to what a page says of an engine where its numbers are in the block.
void addRun(json& data, const Scene& scene, const EngineResult& result, const PlaybackFormat& format,
            std::size_t curveStride, PackedBlock& block) {
    const Observation& run = result.observation;
    if (!run.unsupported.empty()) return;
    data["bodies"] = movingBodies(scene, run.role);
    data["ticks"] = playedTicks(scene, run);
    data["states"] = partData(packPlayback(scene, run, format, block));
    data["probes"] = probeData(scene, run, curveStride, block);
    data["error"] = curveData(result.measured.series.error, curveStride, block);
    data["divergence"] = curveData(result.measured.series.divergence, curveStride, block);
    data["energy"] = curveData(result.measured.series.energy, curveStride, block);
    data["energies"] = energiesData(result.measured.series, curveStride, block);
    data["forces"] = forcesData(scene, run, curveStride, block);
}

json sceneData(const SceneResult& result, const PlaybackFormat& format, const ReportSettings& settings) {
    const Scene& scene = result.scene;
    std::size_t ticks = 1;
    double dt = scene.dt;
    for (const EngineResult& engine : result.engines) {
        if (!engine.observation.unsupported.empty()) continue;
        ticks = std::max(ticks, engine.observation.states.size());
        dt = engine.observation.dt;
    }
    const std::size_t stride = curveStride(ticks, settings.curvePoints);
    json data = sceneView(scene);
    data.update(resultView(result));
    data.update({{"dt", dt},
                 {"steps", ticks - 1},
                 {"stride", format.stride},
                 {"lengthStep", format.lengthStep},
                 {"angleStep", format.angleStep},
                 {"curveStride", stride}});
    PackedBlock block;
    json& engines = data["engines"];
    for (const EngineResult& engine : result.engines)
        for (json& shown : engines)
            if (shown["name"] == engine.observation.engine) addRun(shown, scene, engine, format, stride, block);
    data["packed"] = block.text();
    return data;
}

}  // namespace

json reportData(const std::vector<SceneResult>& results, const std::vector<LabResult>& labs,
                const ReportSettings& settings) {
    const std::vector<PlaybackFormat> formats = fitPlayback(results, settings.playbackBudget);
    json scenes = json::array();
    for (std::size_t i = 0; i < results.size(); ++i) scenes.push_back(sceneData(results[i], formats[i], settings));
    return {{"schema", 1}, {"engines", engineCards(results)}, {"scenes", scenes}, {"labs", labsData(labs)}};
}

std::string scriptText(const json& data) {
    const std::string plain = data.dump(-1, ' ', false, json::error_handler_t::replace);
    std::string safe;
    safe.reserve(plain.size());
    for (const char c : plain) {
        if (c == '<') {
            safe += "\\u003c";
        } else {
            safe += c;
        }
    }
    return safe;
}

}  // namespace plumb::compare
