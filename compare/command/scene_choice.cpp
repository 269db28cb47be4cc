// SPDX-License-Identifier: MIT
#include <compare/command/scene_choice.h>

#include <fmt/format.h>

#include <map>
#include <stdexcept>

#include <compare/scene/builtin.h>
#include <compare/scene/json.h>
#include <compare/scene/nearest.h>

namespace plumb::compare {
namespace {

Scene choose(const std::string& given) {
    if (given.ends_with(".json")) return readScene(given);
    if (std::optional<Scene> scene = findScene(given)) return *std::move(scene);
    std::vector<std::string> names;
    for (const Scene& scene : builtinScenes()) names.push_back(scene.name);
    throw std::invalid_argument(
        fmt::format("there is no scene \"{}\": the nearest is {}; list shows all, and a file "
                    "ends in .json",
                    given, nearest(given, names)));
}

}  // namespace

std::vector<Scene> chooseScenes(std::span<const std::string> given) {
    if (given.empty()) return builtinScenes();
    std::vector<Scene> scenes;
    std::map<std::string, std::string> from;
    for (const std::string& what : given) {
        scenes.push_back(choose(what));
        const auto [first, isNew] = from.try_emplace(scenes.back().name, what);
        if (!isNew)
            throw std::invalid_argument(fmt::format("{} and {} are both called \"{}\": results go by that name",
                                                    first->second, what, first->first));
    }
    return scenes;
}

}  // namespace plumb::compare
