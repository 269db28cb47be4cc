// SPDX-License-Identifier: MIT
#include <compare/report/data.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include <compare/engine/engine_settings.h>

namespace plumb::compare {
namespace {

using nlohmann::json;

constexpr const char* roleTags[] = {"subject", "peer", "guest", "truth"};  // in the order of Role

json cardData(const EngineCard& card) {
    const Look& look = card.look;
    return {{"name", card.name},
            {"label", card.label},
            {"role", roleTags[static_cast<std::size_t>(card.role)]},
            {"onLight", look.onLight},
            {"onDark", look.onDark},
            {"dash", look.dash},
            {"width", look.width},
            {"filled", look.filled},
            {"ghost", look.ghost},
            {"oneSidedChains", card.oneSidedChains}};
}

/// For an engine that is not known: its name and its role.
EngineCard strangerFrom(const Observation& run) {
    EngineCard card;
    card.name = card.label = card.product = run.engine;
    card.version = run.version;
    card.role = run.role;
    return card;
}

}  // namespace

json enginesData(const std::vector<SceneResult>& results) {
    json data = json::array();
    for (const Engine& engine : engines()) {
        data.push_back(cardData(engine));
        if (engine.withBullets) data.push_back(cardData(engine.withBullets()));
    }
    const auto isThere = [&](const std::string& name) {
        return std::ranges::any_of(data, [&](const json& card) { return card["name"] == name; });
    };
    for (const SceneResult& result : results)
        for (const EngineResult& run : result.engines)
            if (!isThere(run.observation.engine)) data.push_back(cardData(strangerFrom(run.observation)));
    return data;
}

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

}  // namespace plumb::compare
