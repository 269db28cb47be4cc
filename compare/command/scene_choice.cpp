// SPDX-License-Identifier: MIT
#include <compare/command/scene_choice.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include <compare/engine/engine.h>
#include <compare/lab/builtin.h>
#include <compare/scene/builtin.h>
#include <compare/scene/named.h>
#include <compare/scene/random/random_scene.h>
#include <compare/scene/scene_file.h>

namespace plumb::compare {
namespace {

/// Refuses a text that is neither the name of a scene nor a file.
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

/// Refuses an unknown name, and lists what bench can run: first the groups, then the single scenes. Scenes of a given
/// size are listed by their group.
[[noreturn]] void refuseBenchName(const std::string& given) {
    std::vector<std::string> shown, names;
    for (const BenchScene& scene : benchScenes()) {
        const bool grouped = !scene.group.empty();
        names.push_back(scene.name);
        if (grouped && std::ranges::find(names, scene.group) == names.end()) names.push_back(scene.group);
        const std::string& name = grouped && scene.group != "six" ? scene.group : scene.name;
        if (std::ranges::find(shown, name) == shown.end()) shown.push_back(name);
    }
    for (const Scene& scene : builtinScenes()) names.push_back(scene.name);
    throw std::invalid_argument(
        fmt::format("there is no scene \"{}\": the nearest is {}; known are six, {}, those that list shows, "
                    "random:SEED, and files that end in .json",
                    given, nearest(given, names), fmt::join(shown, ", ")));
}

/// The scenes for "random:SEED" or "random:A..B"; empty for any other name.
std::vector<BenchScene> randomScenes(const std::string& given) {
    std::vector<BenchScene> found;
    const std::optional<SeedRange> seeds = seedRangeOf(given);
    if (!seeds) return found;
    for (std::uint64_t i = 0; i <= seeds->last - seeds->first; ++i) {
        const std::uint64_t seed = seeds->first + i;
        found.push_back({fmt::format("random_{}", seed), "random", "", [seed] { return randomScene(seed); }});
    }
    return found;
}

/// One scene, or the scenes of a range of seeds.
std::vector<Scene> choose(const std::string& given) {
    if (given.ends_with(".json")) {
        Scene read = readScene(given);
        validateEngineNames(read);
        return {std::move(read)};
    }
    if (std::optional<Scene> scene = findScene(given)) return {*std::move(scene)};
    const std::vector<BenchScene> seeded = randomScenes(given);
    if (!seeded.empty()) {
        std::vector<Scene> scenes;
        for (const BenchScene& scene : seeded) scenes.push_back(scene.build());
        return scenes;
    }
    const std::vector<BenchScene> found = findBenchScenes(given);
    if (found.size() != 1) refuseName(given);
    return {found.front().build()};
}

std::vector<BenchScene> chooseBench(const std::string& given) {
    std::vector<BenchScene> found = findBenchScenes(given);
    if (found.empty()) found = randomScenes(given);
    if (!found.empty()) return found;
    if (!given.ends_with(".json") && !findScene(given) && !findLab(given)) refuseBenchName(given);
    // The scene is made again for each run, so that it takes no memory in the process that waits.
    return {{choose(given).front().name, "", "", [given] { return choose(given).front(); }}};
}

/// Refuses a name that was already used.
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
        for (Scene& scene : choose(what)) {
            once.add(scene.name, what);
            scenes.push_back(std::move(scene));
        }
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
        for (Scene& scene : choose(what)) {
            once.add(scene.name, what);
            choice.scenes.push_back(std::move(scene));
        }
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
