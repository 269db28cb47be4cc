// SPDX-License-Identifier: MIT
#include <compare/view/engine_cards.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include <compare/engine/engines.h>

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

/// Of an engine that is not in the list. If nothing is known of it: its name and its role.
EngineCard strangerFrom(const Observation& run) {
    if (const Engine* known = findKnown(run.engine)) return *known;
    EngineCard card;
    card.name = card.label = card.product = run.engine;
    card.version = run.version;
    card.role = run.role;
    return card;
}

json withNumbers(const Engine& engine) {
    json data = cardData(engine);
    for (const EngineNumber& number : engine.numbers)
        data["numbers"].push_back(
            {{"name", number.name}, {"byDefault", number.byDefault}, {"least", number.least}, {"most", number.most}});
    return data;
}

}  // namespace

json engineCards(std::span<const SceneResult> results) {
    json data = json::array();
    for (const Engine& engine : engines()) {
        data.push_back(withNumbers(engine));
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

json cardsOnDemand() {
    json data = json::array();
    for (const Engine& engine : knownEngines())
        if (engine.build && engine.onDemand) data.push_back(withNumbers(engine));
    data.push_back(cardData(mineEngine({})));
    return data;
}

}  // namespace plumb::compare
