// SPDX-License-Identifier: MIT
// How are measured values written in a cell of a page?
#pragma once
#include <functional>
#include <string>

#include <compare/bench/result.h>

namespace plumb::compare {

/// Null if the engine was not run in the scene, or cannot run it.
const EngineBench* runOf(const SceneBench& scene, std::string_view engine);

/// The name that columnName gives.
std::string displayName(const EngineBench& bench);

/// "1.23 ms", "12.3 µs" below 0.1 ms, "1.23 s" from a second on.
std::string milliseconds(double ms);

/// A cell for each engine of the scene, in its order; "–" if the engine was not run or cannot run it.
std::vector<std::string> cells(const SceneBench& scene, const std::function<std::string(const EngineBench&)>& cell);
/// The same in one cell, separated by " / ".
std::string joinedCells(const SceneBench& scene, const std::function<std::string(const EngineBench&)>& cell);

/// "3.5 m", "infinite", "–".
std::string heightCell(const std::optional<double>& height);
/// As lengthText says it, or "–".
std::string lengthCell(const std::optional<double>& length);

/// The rival's time divided by Plumb's; empty if one of them is missing.
std::optional<Ratio> ratioToRival(const SceneBench& scene);

/// Two significant digits: "1.8", "0.0021".
std::string ratioText(double ratio);

}  // namespace plumb::compare
