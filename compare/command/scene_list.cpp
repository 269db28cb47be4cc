// SPDX-License-Identifier: MIT
#include <compare/command/scene_list.h>

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <fmt/ranges.h>

#include <compare/metric/metrics.h>

namespace plumb::compare {
namespace {

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

}  // namespace

std::string checkText(const Scene& scene, const Check& check) {
    return std::visit([&](const auto& c) { return words(scene, c); }, check);
}

void listScenes(std::span<const Scene> scenes, const std::vector<Engine>& engines, std::ostream& out) {
    for (const Scene& scene : scenes) {
        std::vector<std::string> able;
        for (const Engine& engine : engines)
            if (canBuild(engine, scene)) able.push_back(engine.name);
        fmt::print(out, "{}\n    {}\n    engines {}\n", scene.name, scene.question, fmt::join(able, ", "));
        for (const Check& check : scene.checks) fmt::print(out, "    {}\n", checkText(scene, check));
    }
}

}  // namespace plumb::compare
