// SPDX-License-Identifier: MIT
#include <compare/view/result_view.h>

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include <compare/engine/engine.h>
#include <compare/engine/engine_settings.h>

namespace plumb::compare {
namespace {

using nlohmann::json;

json outcomeData(const Outcome& outcome) {
    return {{"check", outcome.check},   {"engine", outcome.engine},
            {"metric", outcome.metric}, {"value", outcome.value ? json(*outcome.value) : json()},
            {"limit", outcome.limit},   {"pass", outcome.pass},
            {"reason", outcome.reason}};
}

/// The limits that are shown in the charts.
json limitData(const Scene& scene) {
    json limits = json::object();
    for (const Check& check : scene.checks) {
        if (const auto* exact = std::get_if<ExactCheck>(&check)) limits["error"] = exact->limit;
        if (const auto* agree = std::get_if<AgreeCheck>(&check)) {
            limits["divergence"] = agree->tolerance;
            limits["agreeUntil"] = agree->until;
        }
    }
    return limits;
}

/// body is empty if the two stay together.
json partingData(const Scene& scene, const Parting& parting) {
    return {{"a", parting.engineA},
            {"b", parting.engineB},
            {"body", parting.body},
            {"time", parting.time},
            {"text", partingText(scene, parting)}};
}

/// What users of the scene's engines do outside of the engine; each note once.
json notesData(const SceneResult& result) {
    std::vector<std::string> notes;
    for (const EngineResult& run : result.engines) {
        for (const auto& [path, value] : settingsFor(run.observation.engine, result.scene))
            notes.push_back("In " + run.observation.engine + " the scene sets " + path + " to " + value + ".");
        if (const std::string text = ownStepsText(run.ownSteps); !text.empty()) notes.push_back(text);
        const Engine* engine = findKnown(run.observation.engine);
        if (!engine || !engine->notes || !run.observation.unsupported.empty()) continue;
        for (const std::string& note : engine->notes(result.scene))
            if (std::ranges::find(notes, note) == notes.end()) notes.push_back(note);
    }
    return notes;
}

json engineData(const EngineResult& result) {
    const Observation& run = result.observation;
    json settings = json::array();
    for (const Setting& setting : run.settings) settings.push_back({setting.first, setting.second});
    json metrics = json::object();
    for (const auto& [name, value] : result.measured.metrics) metrics[name] = value ? json(*value) : json();
    json data = {{"name", run.engine},
                 {"version", run.version},
                 {"settings", settings},
                 {"metrics", metrics},
                 {"answer", result.answer}};
    if (run.hash) data["hash"] = fmt::format("{:016x}", *run.hash);
    if (!run.unsupported.empty()) data["unsupported"] = run.unsupported;
    return data;
}

}  // namespace

json resultView(const SceneResult& result) {
    const Scene& scene = result.scene;
    json data = {{"changed", result.changed},  {"pass", result.verdict},     {"checks", scene.checks.size()},
                 {"limits", limitData(scene)}, {"notes", notesData(result)}, {"partings", json::array()},
                 {"outcomes", json::array()},  {"engines", json::array()}};
    for (const Parting& parting : result.partings) data["partings"].push_back(partingData(scene, parting));
    for (const Outcome& outcome : result.outcomes) data["outcomes"].push_back(outcomeData(outcome));
    for (const EngineResult& engine : result.engines)
        if (engine.observation.role != Role::Truth || scene.closedForm) data["engines"].push_back(engineData(engine));
    return data;
}

}  // namespace plumb::compare
