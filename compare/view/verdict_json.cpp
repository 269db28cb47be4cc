// SPDX-License-Identifier: MIT
#include <compare/view/verdict_json.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace plumb::compare {
namespace {

using Json = nlohmann::ordered_json;

Json numberOrNull(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

Json engineJson(const EngineResult& run) {
    Json json;
    if (!run.observation.unsupported.empty()) json["unsupported"] = run.observation.unsupported;
    if (!run.answer.empty()) json["answer"] = run.answer;
    json["metrics"] = Json::object();
    for (const auto& [name, value] : run.measured.metrics) json["metrics"][name] = numberOrNull(value);
    if (!run.ownSteps.engine.empty()) {
        json["horizon"] = numberOrNull(run.ownSteps.horizon);
        json["order"] = numberOrNull(run.ownSteps.order);
    }
    if (run.observation.hash) json["hash"] = fmt::format("{:016x}", *run.observation.hash);
    return json;
}

Json outcomeJson(const Outcome& outcome) {
    return {{"check", outcome.check},   {"engine", outcome.engine},
            {"metric", outcome.metric}, {"value", numberOrNull(outcome.value)},
            {"limit", outcome.limit},   {"pass", outcome.pass}};
}

/// body and the fields that depend on it are null if the two engines do not part.
Json partingJson(const Scene& scene, const Parting& parting) {
    Json json{{"engineA", parting.engineA}, {"engineB", parting.engineB}};
    if (parting.body.empty()) {
        for (const char* field : {"body", "time", "quantity", "at", "value"}) json[field] = nullptr;
    } else {
        const bool isBLarger = std::abs(parting.valueB) > std::abs(parting.valueA);
        json["body"] = parting.body;
        json["time"] = parting.time;
        json["limit"] = parting.limit;
        json["quantity"] = differenceName(parting.quantity);
        json["at"] = parting.at;
        json["value"] = numberOrNull(isBLarger ? parting.valueB : parting.valueA);
        json["values"] = {numberOrNull(parting.valueA), numberOrNull(parting.valueB)};
        json["when"] = parting.when;
    }
    json["apart"] = numberOrNull(parting.apart);
    json["portions"] = Json::array();
    for (const Portion& portion : parting.portions)
        json["portions"].push_back(
            {{"by", agentName(portion.agent)}, {"at", portion.other}, {"share", numberOrNull(portion.share)}});
    json["text"] = partingText(scene, parting);
    return json;
}

Json sceneJson(const SceneResult& result) {
    Json json{{"name", result.scene.name}, {"dt", result.scene.dt}, {"steps", stepCount(result.scene)}};
    json["changed"] = result.changed;
    json["unjudged"] = result.unjudged;
    json["engines"] = Json::object();
    for (const EngineResult& run : result.engines) json["engines"][run.observation.engine] = engineJson(run);
    json["checks"] = Json::array();
    for (const Outcome& outcome : result.outcomes) json["checks"].push_back(outcomeJson(outcome));
    json["partings"] = Json::array();
    for (const Parting& parting : result.partings) json["partings"].push_back(partingJson(result.scene, parting));
    json["pass"] = result.verdict;
    return json;
}

Json labJson(const LabResult& result) {
    Json json{{"name", result.lab.name}, {"checks", Json::array()}};
    for (const LabOutcome& outcome : result.outcomes)
        json["checks"].push_back({{"check", outcome.check.name},
                                  {"value", numberOrNull(outcome.value)},
                                  {"limit", outcome.check.limit},
                                  {"pass", outcome.pass}});
    json["pass"] = result.verdict;
    return json;
}

}  // namespace

std::string verdictJson(std::span<const SceneResult> results, std::span<const LabResult> labs) {
    Json json{{"schema", 1}, {"scenes", Json::array()}, {"labs", Json::array()}};
    for (const SceneResult& result : results) json["scenes"].push_back(sceneJson(result));
    for (const LabResult& result : labs) json["labs"].push_back(labJson(result));
    json["pass"] = std::max(overallVerdict(results), overallVerdict(labs));
    return json.dump(1) + "\n";
}

}  // namespace plumb::compare
