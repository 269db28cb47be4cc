// SPDX-License-Identifier: MIT
#include <compare/page/lecture_table.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <compare/check/answer.h>
#include <compare/scene/answer.h>

namespace plumb::compare {
namespace {

AnswerQuery queryOf(const LectureRow& row) {
    return *answerParts(row.scene).front().query;
}

/// None if the run has none, or if it is not a number.
std::optional<double> valueIn(const LectureRow& row, const Observation& run) {
    if (run.states.empty()) return {};
    const std::optional<double> value = valueOf(row.scene, run, queryOf(row));
    return value && std::isfinite(*value) ? value : std::nullopt;
}

/// Two significant digits, but none beyond a hundredth of a percent: "-45 %", "+2.1 %", "+0.02 %", "0.00 %".
std::string offText(double value, double truth) {
    const double percent = 100 * (value / truth - 1), size = std::abs(percent);
    if (size < 0.005) return "0.00 %";
    return fmt::format("{:+.{}f} %", percent, size < 0.995 ? 2 : size < 9.95 ? 1 : 0);
}

const Engine* inBuild(const std::vector<Engine>& engines, const std::string& name) {
    const auto found = std::ranges::find(engines, name, &Engine::name);
    return found == engines.end() ? nullptr : &*found;
}

std::vector<std::string> lectureCells(const LectureRow& row, const Engine& formula,
                                      const std::vector<Engine>& engines) {
    std::vector<std::string> cells{row.label, lectureCell(row, formula, {})};
    const std::optional<double> truth = lectureValue(row, formula);
    for (const std::string& name : accuracyEngines()) {
        const Engine* engine = inBuild(engines, name);
        cells.push_back(engine == nullptr ? "–" : lectureCell(row, *engine, truth));
    }
    return cells;
}

bool haveAllScenes(std::span<const SceneResult> results) {
    return std::ranges::all_of(lectureScenes(), [&](const std::string& name) {
        return std::ranges::any_of(results, [&](const SceneResult& result) { return result.scene.name == name; });
    });
}

}  // namespace

std::optional<double> lectureValue(const LectureRow& row, const Engine& engine) {
    return valueIn(row, observe(row.scene, engine));
}

std::string lectureCell(const LectureRow& row, const Engine& engine, const std::optional<double>& truth) {
    const Observation run = observe(row.scene, engine);
    if (!run.unsupported.empty()) return "has none";
    const std::optional<double> value = valueIn(row, run);
    if (!value) return "does not happen";
    const std::string text = fmt::format("{:#.4g} {}", *value, unitOf(row.scene, queryOf(row)));
    return truth ? fmt::format("{} ({})", text, offText(*value, *truth)) : text;
}

std::optional<AccuracyTable> lectureTable(std::span<const SceneResult> results, const std::vector<Engine>& engines) {
    const auto formula = std::ranges::find(engines, Role::Truth, &Engine::role);
    if (formula == engines.end() || !haveAllScenes(results)) return {};
    AccuracyTable made{"lecture", {"", ""}, {{"what was measured", "formula"}, {}}};
    for (const std::string& name : accuracyEngines()) {
        const Engine* engine = inBuild(engines, name);
        made.engines.push_back(name);
        made.table.head.push_back(engine == nullptr ? name : columnName(name, engine->version));
    }
    for (const LectureRow& row : lectureRows()) made.table.rows.push_back(lectureCells(row, *formula, engines));
    return made;
}

}  // namespace plumb::compare
