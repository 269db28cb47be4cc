// SPDX-License-Identifier: MIT
#include <compare/engine/engine_names.h>

#include <compare/engine/engine.h>
#include <compare/scene/fields.h>
#include <compare/scene/named.h>

namespace plumb::compare {

void validateEngineNames(const Scene& scene) {
    const std::vector<std::string> known = namesOf(knownEngines());
    for (const auto& [engine, fields] : scene.engines) requireKnown(engine, known, "engines." + engine, "an engine");
    for (std::size_t i = 0; i < scene.checks.size(); ++i) {
        const std::string field = at("checks", i) + "." + checkTags[scene.checks[i].index()] + ".engines";
        const auto look = [&](const auto& check) {
            if constexpr (requires { check.engines; })
                for (std::size_t k = 0; k < check.engines.size(); ++k)
                    requireKnown(check.engines[k], known, at(field, k), "an engine");
        };
        std::visit(look, scene.checks[i]);
    }
}

}  // namespace plumb::compare
