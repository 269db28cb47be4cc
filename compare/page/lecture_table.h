// SPDX-License-Identifier: MIT
// How far is each engine off the formulas of a first lecture?
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <compare/check/verdict.h>
#include <compare/page/accuracy_tables.h>
#include <compare/scene/scene.h>

namespace plumb::compare {

struct LectureRow {
    std::string label;  ///< the case, and what is measured in it
    Scene scene;        ///< a built-in scene with other numbers; its answer is the one query that is measured
};

/// The built-in scenes that the rows are made from.
const std::vector<std::string>& lectureScenes();

/// The period of a pendulum for seven amplitudes; the range of a throw for five angles, without drag and with it; the
/// time to fall in Atwood's machine for three ratios of masses.
std::vector<LectureRow> lectureRows();

/// "4.907 s (+0.02 %)": a value, and how far it is off the formula's. truth: the formula's value; none: the cell is
/// the formula's own. "does not happen" if the engine has no value, "has none" if it cannot build the scene.
std::string lectureCell(const LectureRow& row, const Engine& engine, const std::optional<double>& truth);

/// The value of the row's query in an engine; none if what it asks for does not happen.
std::optional<double> lectureValue(const LectureRow& row, const Engine& engine);

/// One row for each of lectureRows, one column for the formula and one for each engine that can be in a build; "–" if
/// this build does not have the engine. Empty if not all of lectureScenes are among the results. The rows are run here.
std::optional<AccuracyTable> lectureTable(std::span<const SceneResult> results, const std::vector<Engine>& engines);

}  // namespace plumb::compare
