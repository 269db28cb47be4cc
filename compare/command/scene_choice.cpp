// SPDX-License-Identifier: MIT
#include <compare/command/scene_choice.h>

#include <fmt/format.h>

#include <map>
#include <stdexcept>

#include <compare/lab/builtin.h>
#include <compare/scene/builtin.h>
#include <compare/scene/json.h>
#include <compare/scene/nearest.h>

namespace plumb::compare {
namespace {

/// What is not a scene's own name, nor a file.
[[noreturn]] void refuseName(const std::string& given) {
    if (findLab(given)) throw std::invalid_argument(fmt::format("{} is a lab, not a scene: check runs it", given));
    std::vector<std::string> names;
    for (const Scene& scene : builtinScenes()) names.push_back(scene.name);
    for (const BenchScene& scene : benchScenes()) names.push_back(scene.name);
    for (const Lab& lab : builtinLabs()) names.push_back(lab.name);
    throw std::invalid_argument(
        fmt::format("there is no scene \"{}\": the nearest is {}; list and bench --help show "
                    "all, and a file ends in .json",
                    given, nearest(given, names)));
}

Scene choose(const std::string& given) {
    if (given.ends_with(".json")) return readScene(given);
    if (std::optional<Scene> scene = findScene(given)) return *std::move(scene);
    const std::vector<BenchScene> found = findBenchScenes(given);
    if (found.size() != 1) refuseName(given);
    return found.front().build();
}

std::vector<BenchScene> chooseBench(const std::string& given) {
    std::vector<BenchScene> found = findBenchScenes(given);
    if (!found.empty()) return found;
    // Made again for each run, so that it takes no room in the process that waits.
    return {{choose(given).name, "", "", [given] { return choose(given); }}};
}

/// Refuses a second thing of the same name.
class Once {
public:
    void add(const std::string& name, const std::string& given) {
        const auto [first, isNew] = from_.try_emplace(name, given);
        if (!isNew)
            throw std::invalid_argument(fmt::format("{} and {} are both called \"{}\": results go by that name",
                                                    first->second, given, first->first));
    }

private:
    std::map<std::string, std::string> from_;
};

}  // namespace

std::vector<Scene> chooseScenes(std::span<const std::string> given) {
    if (given.empty()) return builtinScenes();
    std::vector<Scene> scenes;
    Once once;
    for (const std::string& what : given) {
        scenes.push_back(choose(what));
        once.add(scenes.back().name, what);
    }
    return scenes;
}

Choice chooseScenesAndLabs(std::span<const std::string> given) {
    if (given.empty()) return {builtinScenes(), builtinLabs()};
    Choice choice;
    Once once;
    for (const std::string& what : given) {
        if (std::optional<Lab> lab = findLab(what)) {
            once.add(lab->name, what);
            choice.labs.push_back(*std::move(lab));
            continue;
        }
        choice.scenes.push_back(choose(what));
        once.add(choice.scenes.back().name, what);
    }
    return choice;
}

std::vector<BenchScene> chooseBenchScenes(std::span<const std::string> given) {
    if (given.empty()) return findBenchScenes("six");
    std::vector<BenchScene> scenes;
    Once once;
    for (const std::string& what : given) {
        for (BenchScene& scene : chooseBench(what)) {
            once.add(scene.name, what);
            scenes.push_back(std::move(scene));
        }
    }
    return scenes;
}

}  // namespace plumb::compare
