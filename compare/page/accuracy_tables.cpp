// SPDX-License-Identifier: MIT
#include <compare/page/accuracy_tables.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include <compare/page/cells.h>
#include <compare/page/lecture_table.h>

namespace plumb::compare {
namespace {

enum class Unit { Length, Count, Percent };

/// A row about one scene.
struct Row {
    std::string scene;
    std::string label;                 // the text of the first cell
    std::string watched;               // the text of the second cell; empty if the table has no such cell
    std::vector<std::string> metrics;  // all their values are in one cell
    Unit unit = Unit::Length;
};

const std::vector<std::string> snagsOfThree{"probe.snags_box", "probe.snags_disc", "probe.snags_capsule"};

std::vector<std::string> withMover() {
    std::vector<std::string> four = snagsOfThree;
    four.push_back("probe.snags_mover");
    return four;
}

std::vector<Row> tileRows() {
    return {{"tile_floor", "tile_floor", "", withMover(), Unit::Count},
            {"tile_wall", "tile_wall", "", withMover(), Unit::Count}};
}

std::vector<Row> jointRows() {
    const auto gap = [](const std::string& scene, const std::string& what) {
        return Row{scene, scene + ": " + what, "gap", {"joint_error_max"}};
    };
    const auto energy = [](const std::string& scene, const std::string& what) {
        return Row{scene, scene + ": " + what, "energy lost", {"energy_drift"}, Unit::Percent};
    };
    return {gap("loaded_chain", "10 links carry 1,000 times the mass of a link"),
            gap("catenary", "20 links at rest"),
            gap("bridge_under_load", "60 kg on planks of 2 kg"),
            gap("breaking_bridge", "200 kg fall on it at 10 m/s"),
            gap("scissor_lift", "10 kg lifted"),
            gap("ragdoll", "falls 3 m down stairs"),
            gap("cart_of_a_ton", "lands on wheels of 1.57 kg"),
            gap("doll_on_boulders", "falls 3 m onto loose stones"),
            gap("rope_heaps_up", "60 links fall on each other"),
            energy("spring_undamped", "20 s"),
            energy("double_pendulum_minute", "60 s"),
            energy("cradle_one", "three swings")};
}

std::vector<Row> frontRows() {
    return {
        {"projectile", "A shot at 20 m/s: largest distance from the formula", "", {"error_max"}},
        {"bounce_1", "An elastic ball bounces 20 times: the same", "", {"error_max"}},
        {"pendulum_45", "A pendulum swings 45 degrees wide: the same", "", {"error_max"}},
        {"tile_floor", "A box, a disc, a capsule slide over 95 m of flush tiles: how often each catches", "",
         snagsOfThree, Unit::Count},
        {"loaded_chain", "A chain carries 1,000 times the mass of a link: largest gap", "", {"joint_error_max"}},
        {"bridge_under_load", "A bridge of twenty planks carries three boxes: largest gap", "", {"joint_error_max"}}};
}

const SceneResult* find(std::span<const SceneResult> results, const std::string& scene) {
    const auto found = std::ranges::find(results, scene, [](const SceneResult& r) { return r.scene.name; });
    return found == results.end() ? nullptr : &*found;
}

std::string numberText(double value, Unit unit) {
    if (unit == Unit::Count) return fmt::format("{:.0f}", value);
    if (unit == Unit::Percent) return fmt::format("{:.3g} %", 100 * value);
    return lengthCell(value);
}

/// True if a body is far below the place that the closed form gives it at the end: it fell off what should bear it.
bool hasFallen(const SceneResult& result, const Observation& run) {
    constexpr double far = 100;  // [m]
    const auto truth =
        std::ranges::find(result.engines, Role::Truth, [](const EngineResult& r) { return r.observation.role; });
    if (truth == result.engines.end() || truth->observation.states.empty() || run.states.empty()) return false;
    const std::vector<BodyState>&known = truth->observation.states.back(), &last = run.states.back();
    for (std::size_t body = 0; body < last.size(); ++body)
        if ((last[body].position - known[body].position).dot(result.scene.gravity) > far * result.scene.gravity.norm())
            return true;
    return false;
}

std::string cellOf(const SceneResult& result, const std::string& engine, const Row& row) {
    for (const EngineResult& run : result.engines) {
        if (run.observation.engine != engine) continue;
        if (!run.observation.unsupported.empty()) return "has none";
        if (row.unit == Unit::Length && hasFallen(result, run.observation)) return "fell";
        std::vector<std::string> values;
        for (const std::string& metric : row.metrics) {
            const std::optional<double> value = run.measured.metrics.at(metric);
            values.push_back(value ? numberText(*value, row.unit) : "–");
        }
        return fmt::format("{}", fmt::join(values, ", "));
    }
    return "–";
}

std::string headOf(const SceneResult& result, const std::string& engine) {
    for (const EngineResult& run : result.engines)
        if (run.observation.engine == engine) return columnName(engine, run.observation.version);
    return engine;
}

/// Empty if not all of the table's scenes were run.
std::optional<AccuracyTable> tableFrom(std::span<const SceneResult> results, const std::string& name,
                                       const std::vector<std::string>& heads, const std::vector<Row>& rows) {
    AccuracyTable made{name, std::vector<std::string>(heads.size()), {heads, {}}};
    for (const Row& row : rows) {
        const SceneResult* result = find(results, row.scene);
        if (result == nullptr) return {};
        std::vector<std::string> cells{row.label};
        if (heads.size() > 1) cells.push_back(row.watched);
        for (const std::string& engine : accuracyEngines()) cells.push_back(cellOf(*result, engine, row));
        made.table.rows.push_back(std::move(cells));
    }
    if (rows.empty()) return {};
    for (const std::string& engine : accuracyEngines()) {
        made.engines.push_back(engine);
        made.table.head.push_back(headOf(*find(results, rows.front().scene), engine));
    }
    return made;
}

/// Only if all scenes were run: otherwise readers could not see which ones are missing.
std::vector<Row> distanceRows(std::span<const SceneResult> results) {
    if (find(results, "free_fall") == nullptr || find(results, "arch") == nullptr) return {};
    std::vector<Row> rows;
    for (const SceneResult& result : results)
        if (result.scene.closedForm) rows.push_back({result.scene.name, result.scene.name, "", {"error_max"}});
    return rows;
}

Exactness exactnessOf(const std::string& engine, const AccuracyTable& table) {
    if (engine.empty() || engine == subjectName()) return Exactness::ToTheDigit;
    const auto column = static_cast<std::size_t>(std::ranges::find(table.engines, engine) - table.engines.begin());
    const bool wasRun =
        std::ranges::any_of(table.table.rows, [&](const std::vector<std::string>& row) { return row[column] != "–"; });
    return wasRun && findKnown(engine)->missing.empty() ? Exactness::WithinTwo : Exactness::Unseen;
}

}  // namespace

std::vector<std::string> accuracyEngines() {
    std::vector<std::string> names;
    for (const Engine& engine : knownEngines())
        if (engine.role != Role::Truth && !engine.onDemand) names.push_back(engine.name);
    return names;
}

std::vector<AccuracyTable> accuracyTables(std::span<const SceneResult> results) {
    std::vector<AccuracyTable> tables;
    const auto add = [&](std::optional<AccuracyTable> table) {
        if (table) tables.push_back(*std::move(table));
    };
    add(tableFrom(results, "distances", {"scene"}, distanceRows(results)));
    add(tableFrom(results, "tiles", {"scene: box, disc, capsule, mover"}, tileRows()));
    add(tableFrom(results, "joints", {"scene", "what is watched"}, jointRows()));
    add(tableFrom(results, "accuracy", {"what was measured"}, frontRows()));
    add(lectureTable(results, engines()));
    return tables;
}

std::vector<Block> blocksOf(std::span<const AccuracyTable> tables) {
    std::vector<Block> blocks;
    for (const AccuracyTable& table : tables) blocks.push_back({"check", table.name, "", markdown(table.table)});
    return blocks;
}

std::vector<std::string> pageFaults(const std::string& page, std::span<const AccuracyTable> tables) {
    std::vector<std::string> faults;
    for (const Block& block : blocksOf(page)) {
        if (!block.isIntact())
            faults.push_back(fmt::format("the block {} was changed since {} wrote it", block.name, block.command));
        const auto measured = std::ranges::find(tables, block.name, &AccuracyTable::name);
        if (block.command != "check" || measured == tables.end()) continue;
        std::vector<Exactness> columns;
        for (const std::string& engine : measured->engines) columns.push_back(exactnessOf(engine, *measured));
        for (const std::string& difference : differences(tableOf(block.body), measured->table, columns))
            faults.push_back(fmt::format("the table {}: {}", block.name, difference));
    }
    return faults;
}

}  // namespace plumb::compare
