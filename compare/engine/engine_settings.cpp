// SPDX-License-Identifier: MIT
#include <compare/engine/engine_settings.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include <compare/scene/json_text.h>
#include <compare/scene/named.h>
#include <compare/scene/set_field.h>

namespace plumb::compare {
namespace {

constexpr std::string_view ownMark = "solver.";

bool isOwn(const std::string& path) {
    return path.starts_with(ownMark);
}

std::string fieldOf(const std::string& engine, const std::string& path) {
    return "engines." + engine + "." + path;
}

/// Only some fields may differ between engines. The others say how long a run is and what is measured.
void requireSettable(const std::string& engine, const std::string& path) {
    static const std::vector<std::string> settable{"gravity", "sleeping", "bodies", "joints", "fields", "movers"};
    const std::string first = path.substr(0, path.find('.'));
    if (std::ranges::find(settable, first) == settable.end())
        refuse(fieldOf(engine, path), "is the same for all engines; what may differ is " + listText(settable) +
                                          ", and an engine's own numbers, with \"solver.\"");
}

/// The engine's fields by their paths; empty if the scene sets nothing for the engine.
const std::map<std::string, std::string>& fieldsFor(const std::string& engine, const Scene& scene) {
    static const std::map<std::string, std::string> none;
    const auto found = scene.engines.find(engine);
    return found == scene.engines.end() ? none : found->second;
}

}  // namespace

Scene sceneFor(const std::string& engine, const Scene& scene) {
    Scene made = scene;
    for (const auto& [path, value] : fieldsFor(engine, scene)) {
        if (isOwn(path)) continue;
        requireSettable(engine, path);
        try {
            made = withJsonField(made, path, Json::parse(value));
        } catch (const std::invalid_argument& error) {
            throw std::invalid_argument("engines." + engine + ": " + error.what());
        }
    }
    return made;
}

double numberFor(const std::string& engine, const EngineNumber& number, const Scene& scene) {
    const std::map<std::string, std::string>& fields = fieldsFor(engine, scene);
    const auto given = fields.find(std::string(ownMark) + number.name);
    if (given == fields.end()) return number.byDefault;
    const Json value = Json::parse(given->second);
    const std::string field = fieldOf(engine, given->first);
    if (!value.is_number()) refuse(field, value.dump() + " is not a number");
    const double found = value.get<double>();
    if (!(found >= number.least && found <= number.most))
        refuse(field, toText(found) + " is not from " + toText(number.least) + " to " + toText(number.most));
    return found;
}

std::vector<Setting> settingsFor(const std::string& engine, const Scene& scene) {
    std::vector<Setting> settings;
    for (const auto& [path, value] : fieldsFor(engine, scene))
        settings.emplace_back(path, value + ", for this engine alone");
    return settings;
}

Engine takingSettings(Engine engine) {
    if (!engine.build) return engine;
    const auto build = engine.build;
    const auto settings = engine.settings;
    const auto numbers = engine.numbers;
    engine.build = [name = engine.name, build, numbers](const Scene& scene) {
        const std::vector<std::string> known = namesOf(numbers);
        for (const auto& [path, value] : fieldsFor(name, scene))
            if (isOwn(path))
                requireKnown(path.substr(ownMark.size()), known, fieldOf(name, path), "a number of this engine");
        return build(sceneFor(name, scene));
    };
    engine.settings = [name = engine.name, settings](const Scene& scene) {
        std::vector<Setting> all = settings(sceneFor(name, scene));
        for (Setting& setting : settingsFor(name, scene)) all.push_back(std::move(setting));
        return all;
    };
    return engine;
}

}  // namespace plumb::compare
