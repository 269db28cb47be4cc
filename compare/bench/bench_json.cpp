// SPDX-License-Identifier: MIT
#include <compare/bench/bench_json.h>

#include <nlohmann/json.hpp>

#include <compare/bench/integrity.h>

namespace plumb::compare {
namespace {

using Json = nlohmann::ordered_json;

Json spreadJson(const Spread& spread) {
    return {{"min", spread.min}, {"median", spread.median}, {"max", spread.max}};
}

Json stepsJson(const StepTimes& times) {
    return {{"median", times.median}, {"p99", times.p99}, {"worst", times.worst}};
}

Json phasesJson(const std::vector<Phase>& phases) {
    Json json = Json::object();
    for (const Phase& phase : phases) json[phase.name] = phase.seconds * 1000;
    return json;
}

Json runJson(const SceneBench& scene, const EngineBench& bench) {
    Json json{{"scene", scene.scene}, {"engine", bench.engine}, {"threads", 1}, {"bodies", scene.bodies}};
    if (!bench.supported()) {
        json.update({{"unsupported", bench.runs.front().unsupported},
                     {"ms_per_step", nullptr},
                     {"least_ms", nullptr},
                     {"step_ms", nullptr},
                     {"integrity", nullptr},
                     {"peak_kb", nullptr}});
        return json;
    }
    json.update({{"ms_per_step", spreadJson(bench.msPerStep())},
                 {"least_ms", bench.leastMs()},
                 {"step_ms", stepsJson(bench.stepMs())},
                 {"integrity", integrityJson(bench.integrity())},
                 {"peak_kb", bench.peakKb()},
                 {"steps", scene.steps},
                 {"repeats", bench.runs.size()},
                 {"busy", bench.busy()},
                 {"phases", phasesJson(bench.phases())}});
    return json;
}

}  // namespace

std::string benchJson(std::span<const SceneBench> results) {
    Json json{{"schema", 1}};
    for (const char* list : {"runs", "ratios", "mean_ratios", "growth"}) json[list] = Json::array();
    for (const SceneBench& scene : results)
        for (const EngineBench& bench : scene.engines) json["runs"].push_back(runJson(scene, bench));
    for (const Ratio& ratio : ratiosOf(results))
        json["ratios"].push_back({{"scene", ratio.scene},
                                  {"engine", subjectName()},
                                  {"against", ratio.against},
                                  {"ratio", spreadJson(ratio.ratio)},
                                  {"least", ratio.least},
                                  {"broken", ratio.broken}});
    for (const MeanRatio& mean : meanRatiosOf(results))
        json["mean_ratios"].push_back({{"group", mean.group},
                                       {"engine", subjectName()},
                                       {"against", mean.against},
                                       {"ratio", mean.ratio},
                                       {"scenes", mean.scenes},
                                       {"left_out", mean.leftOut}});
    for (const Growth& growth : growthsOf(results))
        json["growth"].push_back({{"family", growth.family},
                                  {"engine", growth.engine},
                                  {"exponent", growth.exponent},
                                  {"from", growth.from},
                                  {"to", growth.to}});
    return json.dump(1) + "\n";
}

}  // namespace plumb::compare
