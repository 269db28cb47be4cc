// SPDX-License-Identifier: MIT
#include <compare/page/speed_tables.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <compare/page/cells.h>
#include <compare/page/page_table.h>

namespace plumb::compare {
namespace {

struct Compared {
    const SceneBench* scene;
    const EngineBench *plumb, *rival;
    double ratio;  // the rival's time divided by Plumb's
};

std::vector<Compared> comparedIn(std::span<const SceneBench> results) {
    std::vector<Compared> found;
    for (const SceneBench& scene : results) {
        const std::optional<Ratio> ratio = ratioToRival(scene);
        if (scene.group == "random" && ratio && !ratio->broken)
            found.push_back({&scene, runOf(scene, subjectName()), runOf(scene, rivalName()), ratio->least});
    }
    std::ranges::stable_sort(found, {}, &Compared::ratio);
    return found;
}

/// scenes: sorted by their ratios.
std::vector<std::string> sumRow(const std::string& label, const std::vector<Compared>& scenes) {
    double logs = 0;
    std::size_t faster = 0, passed = 0, passedRival = 0, deeper = 0;
    for (const Compared& each : scenes) {
        const Integrity plumb = each.plumb->integrity(), rival = each.rival->integrity();
        logs += std::log(each.ratio);
        faster += each.ratio > 1 ? 1u : 0u;
        deeper += plumb.overlap > rival.overlap ? 1u : 0u;
        passed += plumb.passedWalls.value_or(0);
        passedRival += rival.passedWalls.value_or(0);
    }
    return {label,
            std::to_string(scenes.size()),
            ratioText(std::exp(logs / static_cast<double>(scenes.size()))),
            fmt::format("{} to {}", ratioText(scenes.front().ratio), ratioText(scenes.back().ratio)),
            std::to_string(faster),
            std::to_string(deeper),
            fmt::format("{} / {}", passed, passedRival)};
}

std::vector<std::string> row(const Compared& each) {
    return {each.scene->scene,
            each.scene->question,
            std::to_string(each.scene->bodies),
            milliseconds(each.plumb->leastMs()),
            milliseconds(each.rival->leastMs()),
            ratioText(each.ratio)};
}

}  // namespace

Block randomBlock(std::span<const SceneBench> results) {
    const std::vector<Compared> all = comparedIn(results);
    if (all.empty()) return {"bench", "random", "", ""};
    std::vector<Compared> loose, jointed;
    for (const Compared& each : all) (each.scene->joints > 0 ? jointed : loose).push_back(each);
    const std::string over = displayName(*all.front().rival) + " over Plumb";
    PageTable sums{
        {"random scenes", "number", over + ", geometric mean", "least to most", "Plumb is faster in",
         "Plumb overlaps deeper in", "bodies that passed a wall: Plumb / " + findKnown(rivalName())->product},
        {}};
    sums.rows.push_back(sumRow("all", all));
    if (!loose.empty()) sums.rows.push_back(sumRow("without joints", loose));
    if (!jointed.empty()) sums.rows.push_back(sumRow("with joints", jointed));
    PageTable ends{
        {"scene", "what is in it", "bodies", displayName(*all.front().plumb), displayName(*all.front().rival), over},
        {}};
    constexpr std::size_t few = 4;  // shown at each end
    for (std::size_t i = 0; i < all.size(); ++i)
        if (i < few || i + few >= all.size()) ends.rows.push_back(row(all[i]));
    return {"bench", "random", "",
            markdown(sums) + "\nThe scenes in which Plumb is slowest, and those in which it is fastest:\n\n" +
                markdown(ends)};
}

}  // namespace plumb::compare
