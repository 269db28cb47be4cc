// SPDX-License-Identifier: MIT
#include <compare/engine/engine.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "catch.h"
#include "compare/scripted.h"
#include "house/repository.h"

namespace plumb::compare {
namespace {

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// What would give an engine away: its product's name, and in quotes what it is called on the command line.
std::set<std::string> marksOfEngines() {
    std::set<std::string> marks;
    for (const Engine& engine : knownEngines()) {
        // A method of a textbook has the name that everybody has for it.
        if (engine.onDemand) continue;
        const bool isOthers = engine.role == Role::Peer || engine.role == Role::Guest;
        if (isOthers) marks.insert(lower(engine.product));
        for (const char quote : {'"', '\''}) marks.insert(quote + engine.name + quote);
    }
    return marks;
}

/// Scenes give their reasons and sources, and are made of what each engine takes.
bool mayName(const std::string& path) {
    return std::ranges::any_of(std::vector<std::string>{"engine/", "scene/builtin/", "scene/bench/", "scene/random/"},
                               [&](const std::string& folder) { return path.starts_with("compare/" + folder); });
}

std::string complaintOf(const Scene& scene) {
    try {
        validateEngineNames(scene);
        return "";
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
}

}  // namespace

TEST_CASE("no source and no script of the comparison names an engine, but in the engines' folder",
          "[compare][engine][house]") {
    int searched = 0;
    for (const std::filesystem::path& path : test::repositoryFiles()) {
        const std::string name = path.generic_string();
        const bool isSource = std::set<std::string>{".h", ".cpp", ".js"}.contains(path.extension().string());
        if (!name.starts_with("compare/") || !isSource || mayName(name)) continue;
        ++searched;
        const std::string text = lower(test::textOf(test::repository / path));
        for (const std::string& mark : marksOfEngines()) {
            INFO(name << " names " << mark);
            CHECK(text.find(mark) == std::string::npos);
        }
    }
    CHECK(searched > 150);
}

TEST_CASE("one engine is under test, one is its rival, one is the truth, and no two look the same",
          "[compare][engine]") {
    const std::vector<Engine>& known = knownEngines();
    CHECK(std::ranges::count(known, Role::Subject, &Engine::role) == 1);
    CHECK(std::ranges::count(known, Role::Truth, &Engine::role) == 1);
    CHECK(std::ranges::count(known, true, &Engine::isRival) == 1);
    std::set<std::string> colours, labels;
    for (const Engine& engine : known) {
        INFO(engine.name);
        CHECK(colours.insert(engine.look.onLight).second);
        CHECK(labels.insert(engine.label).second);
        CHECK((engine.build || !engine.missing.empty()));
    }
}

TEST_CASE("an engine that a check names and nobody knows is refused by field and nearest name",
          "[compare][engine][errors]") {
    Scene scene = oneDisc();
    scene.checks = {InvariantCheck{.metric = "energy_drift", .engines = {"plumb", "box2d"}}};
    CHECK(complaintOf(scene).starts_with(
        "checks[0].invariant.engines[1]: \"box2d\" is not the name of an engine, the nearest is box2d-3"));
    scene.checks = {InvariantCheck{.metric = "energy_drift", .engines = {"plumb", "box2d-3"}}, OrderCheck{}};
    CHECK(complaintOf(scene).empty());
}

}  // namespace plumb::compare
