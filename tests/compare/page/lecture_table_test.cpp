// SPDX-License-Identifier: MIT
#include <compare/page/lecture_table.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <compare/scene/builtin.h>

#include "catch.h"
#include "compare/scripted.h"
#include "numbers.h"

namespace plumb::compare {
namespace {

constexpr double lectureGravity = 9.81;

/// T = 2 pi sqrt(L / g) / AGM(1, cos(a / 2)), with L = l + r^2 / (2 l) of a disc of radius 0.1 m on a rod of 1 m.
double periodByMean(double amplitude) {
    double arithmetic = 1, geometric = std::cos(amplitude / 2);
    for (int i = 0; i < 8; ++i) {
        const double mean = (arithmetic + geometric) / 2;
        geometric = std::sqrt(arithmetic * geometric);
        arithmetic = mean;
    }
    return 2 * test::pi * std::sqrt(1.005 / lectureGravity) / arithmetic;
}

/// 20^2 sin(2 a) / g.
double rangeOf(double angle) {
    return 400 * std::sin(2 * angle) / lectureGravity;
}

/// Halves the time until y = (v sin a + g / k) (1 - e^(-k t)) / k - g t / k is 0; x = v cos a (1 - e^(-k t)) / k there.
double rangeInAir(double angle) {
    const double k = 0.2, up = 20 * std::sin(angle), along = 20 * std::cos(angle);
    const auto share = [&](double t) { return (1 - std::exp(-k * t)) / k; };
    double early = up / lectureGravity, late = 2 * early;
    for (int i = 0; i < 60; ++i) {
        const double t = (early + late) / 2;
        const double y = (up + lectureGravity / k) * share(t) - lectureGravity * t / k;
        (y > 0 ? early : late) = t;
    }
    return along * share(early);
}

/// 1 m at g (m - 1) / (m + 1).
double fallBeside(double mass) {
    return std::sqrt(2 * (mass + 1) / (lectureGravity * (mass - 1)));
}

/// In the order of the rows.
std::vector<double> textbookValues() {
    const auto radians = [](double degrees) { return degrees * test::pi / 180; };
    std::vector<double> values;
    for (const double amplitude : {10, 30, 60, 90, 120, 150, 170}) values.push_back(periodByMean(radians(amplitude)));
    for (const double angle : {15, 30, 45, 60, 75}) values.push_back(rangeOf(radians(angle)));
    for (const double angle : {15, 30, 45, 60, 75}) values.push_back(rangeInAir(radians(angle)));
    for (const double mass : {1.1, 2.0, 10.0}) values.push_back(fallBeside(mass));
    return values;
}

const Engine& withRole(Role role) {
    return *std::ranges::find(engines(), role, &Engine::role);
}

std::vector<SceneResult> resultsOf(const std::vector<std::string>& scenes) {
    std::vector<SceneResult> results(scenes.size());
    for (std::size_t i = 0; i < scenes.size(); ++i) results[i].scene.name = scenes[i];
    return results;
}

const LectureRow& rowOf(const std::vector<LectureRow>& rows, const std::string& start) {
    return *std::ranges::find_if(rows, [&](const LectureRow& row) { return row.label.starts_with(start); });
}

/// Lands after 2 s, at 20 m.
Engine landsAtTwenty() {
    return scripted("plumb", {[](double t) {
                        BodyState state = at(10 * t, 5 * t * (2 - t));
                        state.velocity = {10, 10 - 10 * t};
                        return std::vector<BodyState>{state};
                    }});
}

}  // namespace

TEST_CASE("the lecture's formulas give the textbook's 20 values, and Plumb is within a thousandth of each",
          "[compare][page][law]") {
    const std::vector<LectureRow> rows = lectureRows();
    const std::vector<double> textbook = textbookValues();
    REQUIRE(rows.size() == textbook.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        INFO(rows[i].label);
        const std::optional<double> formula = lectureValue(rows[i], withRole(Role::Truth));
        const std::optional<double> plumb = lectureValue(rows[i], withRole(Role::Subject));
        REQUIRE((formula && plumb));
        // The middle of a swing is taken from ticks. Where a run has one half of it, x is largest between two of them.
        CHECK(std::abs(*formula / textbook[i] - 1) < 2e-5);
        CHECK(std::abs(*plumb / textbook[i] - 1) < 1e-3);
    }
}

TEST_CASE("a period of the lecture's table is that which the scene answers", "[compare][page]") {
    const SceneResult result = runScene(*findScene("pendulum_150"), {}, engines());
    const std::vector<LectureRow> rows = lectureRows();
    for (const EngineResult& run : result.engines) {
        INFO(run.observation.engine);
        const Engine& engine = *std::ranges::find(engines(), run.observation.engine, &Engine::name);
        const double period = lectureValue(rowOf(rows, "Pendulum, 150 degrees"), engine).value();
        CHECK(run.answer.find(fmt::format(" {:.3g} s.", period)) != std::string::npos);
    }
}

TEST_CASE("a cell of the lecture says how far a value is off, what does not happen, and what an engine lacks",
          "[compare][page]") {
    const std::vector<LectureRow> rows = lectureRows();
    const LectureRow& row = rowOf(rows, "Throw");
    CHECK(lectureCell(row, landsAtTwenty(), {}) == "20.00 m");
    CHECK(lectureCell(row, landsAtTwenty(), 20.0) == "20.00 m (0.00 %)");
    CHECK(lectureCell(row, landsAtTwenty(), 20.02) == "20.00 m (-0.10 %)");
    CHECK(lectureCell(row, landsAtTwenty(), 19.6) == "20.00 m (+2.0 %)");
    CHECK(lectureCell(row, landsAtTwenty(), 40.0) == "20.00 m (-50 %)");
    CHECK(lectureCell(row, standing("plumb", 1), 20.0) == "does not happen");
    CHECK(lectureCell(row, unsupporting("plumb"), 20.0) == "has none");
}

TEST_CASE("the lecture's table fills its block, and each changed digit of Plumb's is found", "[compare][page]") {
    const std::optional<AccuracyTable> table = lectureTable(resultsOf(lectureScenes()), engines());
    REQUIRE(table);
    const std::vector<AccuracyTable> tables{*table};
    const std::string empty = "# Page\n\n<!-- check: lecture -->\n<!-- end -->\n";
    CHECK_FALSE(pageFaults(empty, tables).empty());
    const std::string page = withBlocks(empty, blocksOf(tables));
    CHECK(pageFaults(page, tables).empty());
    CHECK(page.find("| Pendulum, 170 degrees: period | 4.906 s | 4.906 s (0.00 %) |") != std::string::npos);
    AccuracyTable changed = *table;
    std::string& cell = changed.table.rows[6][2];
    cell.replace(cell.find("4.906"), 5, "4.907");
    CHECK(pageFaults(withBlocks(empty, blocksOf(std::vector{changed})), tables).size() == 1);
}

TEST_CASE("the lecture's table wants all of its scenes, and has no numbers of an engine that is not in the build",
          "[compare][page]") {
    CHECK_FALSE(lectureTable(resultsOf({"pendulum_150", "projectile"}), engines()));
    const std::optional<AccuracyTable> table =
        lectureTable(resultsOf(lectureScenes()), {withRole(Role::Subject), withRole(Role::Truth)});
    REQUIRE(table);
    CHECK(table->engines.size() == table->table.head.size());
    for (const std::vector<std::string>& row : table->table.rows) {
        REQUIRE(row.size() == table->table.head.size());
        for (std::size_t i = 3; i < row.size(); ++i) CHECK(row[i] == "–");
    }
}

}  // namespace plumb::compare
