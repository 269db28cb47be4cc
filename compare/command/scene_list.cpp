// SPDX-License-Identifier: MIT
#include <compare/command/scene_list.h>

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <stdexcept>
#include <utility>

#include <compare/command/lab_text.h>
#include <compare/metric/metrics.h>

namespace plumb::compare {
namespace {

constexpr const char* labsHeading = "Labs";

std::string headingOf(const Scene& scene) {
    return scene.group.empty() ? "Others" : scene.group;
}

std::string inSmallLetters(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

bool isInOneOf(std::initializer_list<std::string> texts, const std::string& word) {
    return std::ranges::any_of(
        texts, [&](const std::string& text) { return inSmallLetters(text).find(word) != std::string::npos; });
}

std::string boundText(const std::vector<std::string>& engines) {
    return engines.empty() ? subjectName() : fmt::format("{}", fmt::join(engines, ", "));
}

std::string words(const Scene&, const ExactCheck& check) {
    return fmt::format("exact: {} within {:.4g} m", subjectName(), check.limit);
}

std::string words(const Scene&, const AgreeCheck& check) {
    return fmt::format("agree: {} and each peer within {:.4g} m until {:.4g} s", subjectName(), check.tolerance,
                       check.until);
}

std::string words(const Scene& scene, const InvariantCheck& check) {
    const std::string unit = metricUnit(scene, check.metric);
    return fmt::format("invariant: {} at most {:.4g}{}{} ({})", check.metric, check.limit, unit.empty() ? "" : " ",
                       unit, boundText(check.engines));
}

std::string words(const Scene&, const OrderCheck& check) {
    return fmt::format("order: at least {:.4g} ({})", check.order, boundText(check.engines));
}

bool canBuild(const Engine& engine, const Scene& scene) {
    try {
        engine.build(scene);
        return true;
    } catch (const Unsupported&) {
        return false;
    }
}

void listScenes(const std::vector<Scene>& scenes, const std::vector<Engine>& engines, std::ostream& out) {
    for (const Scene& scene : scenes) {
        std::vector<std::string> able;
        for (const Engine& engine : engines)
            if (canBuild(engine, scene)) able.push_back(engine.name);
        fmt::print(out, "{}\n    {}\n    engines {}\n", scene.name, scene.question, fmt::join(able, ", "));
        for (const Check& check : scene.checks) fmt::print(out, "    {}\n", checkText(scene, check));
    }
}

}  // namespace

std::string checkText(const Scene& scene, const Check& check) {
    return std::visit([&](const auto& c) { return words(scene, c); }, check);
}

Choice containing(Choice all, const std::string& word) {
    const std::string small = inSmallLetters(word);
    std::erase_if(all.scenes, [&](const Scene& scene) {
        return !isInOneOf({scene.name, headingOf(scene), scene.question}, small);
    });
    std::erase_if(all.labs, [&](const Lab& lab) { return !isInOneOf({lab.name, labsHeading, lab.question}, small); });
    if (all.scenes.empty() && all.labs.empty())
        throw std::invalid_argument(fmt::format(
            "list: no scene or lab has \"{}\" in its name, group or question; list without a word shows all", word));
    return all;
}

void listByGroup(const Choice& shown, const std::vector<Engine>& engines, std::ostream& out) {
    std::vector<std::pair<std::string, std::vector<Scene>>> groups;
    for (const Scene& scene : shown.scenes) {
        const std::string heading = headingOf(scene);
        auto group = std::ranges::find(groups, heading, &std::pair<std::string, std::vector<Scene>>::first);
        if (group == groups.end()) group = groups.insert(groups.end(), {heading, {}});
        group->second.push_back(scene);
    }
    const char* gap = "";
    for (const auto& [heading, scenes] : groups) {
        fmt::print(out, "{}== {} ==\n", std::exchange(gap, "\n"), heading);
        listScenes(scenes, engines, out);
    }
    if (!shown.labs.empty()) fmt::print(out, "{}== {} ==\n", gap, labsHeading);
    listLabs(shown.labs, out);
}

}  // namespace plumb::compare
