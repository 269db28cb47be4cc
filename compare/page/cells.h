// SPDX-License-Identifier: MIT
// How does what was measured stand in a cell of a page?
#pragma once
#include <functional>
#include <string>

#include <compare/bench/result.h>

namespace plumb::compare {

/// Null when the engine was not run in the scene, or could not.
const EngineBench* runOf(const SceneBench& scene, std::string_view engine);

/// As columnName has it.
std::string displayName(const EngineBench& bench);

/// "1.23 ms", "12.3 µs" below 0.1 ms, "1.23 s" from a second on.
std::string milliseconds(double ms);

/// A cell for each engine of the scene, in its order; "–" where it was not run or could not.
std::vector<std::string> cells(const SceneBench& scene, const std::function<std::string(const EngineBench&)>& cell);
/// The same in one cell, with " / " between.
std::string joinedCells(const SceneBench& scene, const std::function<std::string(const EngineBench&)>& cell);

/// "3.5 m", "infinite", "–".
std::string heightCell(const std::optional<double>& height);
/// As lengthText, with µm.
std::string lengthCell(const std::optional<double>& length);

/// Of the rival over Plumb; empty where one of them is missing.
std::optional<Ratio> ratioToRival(const SceneBench& scene);

/// Two digits that count: "1.8", "0.0021".
std::string ratioText(double ratio);

}  // namespace plumb::compare
