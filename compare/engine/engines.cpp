// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>

#include <compare/engine/engine.h>
#include <compare/engine/engine_settings.h>
#include <compare/engine/engines.h>
#include <compare/scene/fields.h>
#include <compare/scene/named.h>

namespace plumb::compare {

const std::vector<Engine>& knownEngines() {
    static const std::vector<Engine> list = [] {
        std::vector<Engine> all{
            plumbEngine(), box2d24Engine(), box2d3Engine(), chipmunkEngine(), closedFormEngine(),
        };
        std::ranges::move(textbookEngines(), std::back_inserter(all));
        for (Engine& engine : all) engine = takingSettings(std::move(engine));
        return all;
    }();
    return list;
}

const std::vector<Engine>& engines() {
    static const std::vector<Engine> list = [] {
        std::vector<Engine> found;
        std::ranges::copy_if(knownEngines(), std::back_inserter(found),
                             [](const Engine& e) { return e.build && !e.onDemand; });
        return found;
    }();
    return list;
}

std::vector<Engine> enginesWith(const std::vector<std::string>& names) {
    std::vector<Engine> found;
    std::ranges::copy_if(knownEngines(), std::back_inserter(found), [&](const Engine& e) {
        return e.build && (!e.onDemand || std::ranges::find(names, e.name) != names.end());
    });
    return found;
}

const Engine* findKnown(std::string_view name) {
    const auto found = std::ranges::find(knownEngines(), name, &Engine::name);
    if (found != knownEngines().end()) return &*found;
    static const Engine mine = mineEngine({});
    return name == mine.name ? &mine : nullptr;
}

const std::string& subjectName() {
    return std::ranges::find(knownEngines(), Role::Subject, &Engine::role)->name;
}

const std::string& rivalName() {
    return std::ranges::find(knownEngines(), true, &Engine::isRival)->name;
}

std::string columnName(const std::string& name, const std::string& version) {
    const Engine* engine = findKnown(name);
    if (!engine) return name;
    return engine->role == Role::Subject ? engine->product : engine->product + " " + version;
}

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
