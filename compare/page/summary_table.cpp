// SPDX-License-Identifier: MIT
#include <compare/page/speed_tables.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <compare/page/cells.h>
#include <compare/page/page_table.h>

namespace plumb::compare {
namespace {

struct Kind {
    const char* scene;
    const char* label;
};

constexpr Kind kinds[] = {
    {"small_50", "50 boxes and balls of a small game"},
    {"large_pyramid", "A pyramid of 5,050 boxes"},
    {"washer", "8,100 boxes in a turning drum"},
    {"pit_2000", "2,000 boxes and balls fall into a pit"},
    {"spinner", "6,076 bodies stirred in a ring"},
    {"junkyard", "8,000 pentagons pushed about"},
    {"compounds", "3,000 bodies of two triangles each"},
    {"joint_grid", "A net of 10,000 discs and 19,794 hinges"},
    {"dolls_100", "100 dolls in a heap"},
    {"rain", "1,000 dolls that rain"},
    {"bridge_20", "A bridge of twenty planks"},
    {"rope_60", "A rope of 60 links that falls in a heap"},
};

constexpr Kind jointedKinds[] = {
    {"bridge_20", "A bridge of 20 hinged planks under three boxes"},
    {"truss_32", "A truss of 32 bays, 128 rods, under a ton"},
    {"cloth_20", "A cloth of 400 discs and 741 rods"},
    {"net_20", "A net of 400 discs and 754 hinges"},
    {"net_40", "A net of 1,600 discs and 3,114 hinges"},
};

/// "1.8 times as fast" or "140 times as slow".
std::string verdictOf(double ratio) {
    if (std::abs(ratio - 1) < 0.05) return "as fast";
    if (ratio >= 1) return fmt::format("{} times as fast", ratioText(ratio));
    return fmt::format("{} times as slow", ratioText(1 / ratio));
}

/// The larger of the deepest overlap and the largest gap: speed does not count if the result is wrong.
std::optional<double> faultOf(const Integrity& seen) {
    return std::max(seen.overlap, seen.jointGap);
}

std::optional<double> gapOf(const Integrity& seen) {
    return seen.jointGap;
}

/// What nobody tuned to, in one row.
std::vector<std::string> randomRow(std::span<const SceneBench> results, const MeanRatio& mean) {
    const auto isFaster = [](const SceneBench& scene) {
        const std::optional<Ratio> ratio = ratioToRival(scene);
        return scene.group == "random" && ratio && !ratio->broken && ratio->least > 1;
    };
    const std::string label = fmt::format("{} random scenes, geometric mean; Plumb is faster in {}", mean.scenes,
                                          std::ranges::count_if(results, isFaster));
    return {label, "–", "–", verdictOf(mean.ratio), "–"};
}

/// One row for each kind. Without rows if one of the scenes was not run in both engines.
PageTable kindsTable(std::span<const Kind> some, std::span<const SceneBench> results, const std::string& faults,
                     std::optional<double> (*fault)(const Integrity&)) {
    const std::string& product = findKnown(rivalName())->product;
    PageTable table{{"a step of", columnName(subjectName(), ""), product, "Plumb is", faults + ": Plumb / " + product},
                    {}};
    for (const Kind& kind : some) {
        const auto scene = std::ranges::find(results, kind.scene, &SceneBench::scene);
        if (scene == results.end()) return {};
        const EngineBench *plumb = runOf(*scene, subjectName()), *rival = runOf(*scene, rivalName());
        if (plumb == nullptr || rival == nullptr) return {};
        table.head[2] = displayName(*rival);
        table.rows.push_back({kind.label, milliseconds(plumb->leastMs()), milliseconds(rival->leastMs()),
                              verdictOf(ratioToRival(*scene)->least),
                              lengthCell(fault(plumb->integrity())) + " / " + lengthCell(fault(rival->integrity()))});
    }
    return table;
}

}  // namespace

Block summaryBlock(std::span<const SceneBench> results) {
    Block block{"bench", "summary", "", ""};
    PageTable table = kindsTable(kinds, results, "bodies overlap, or a joint gapes, by up to", faultOf);
    if (table.rows.empty()) return block;
    for (const MeanRatio& mean : meanRatiosOf(results))
        if (mean.group == "random" && mean.against == rivalName()) table.rows.push_back(randomRow(results, mean));
    block.body = markdown(table);
    return block;
}

Block jointedBlock(std::span<const SceneBench> results) {
    const PageTable table = kindsTable(jointedKinds, results, "a joint gapes by up to", gapOf);
    return {"bench", "jointed", "", table.rows.empty() ? "" : markdown(table)};
}

}  // namespace plumb::compare
