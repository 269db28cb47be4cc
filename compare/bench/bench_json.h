// SPDX-License-Identifier: MIT
// How do measured times look to a program?
#pragma once
#include <span>
#include <string>

#include <compare/bench/result.h>

namespace plumb::compare {

/// {"schema":1,"runs":[{"scene","engine","threads","bodies","ms_per_step":{"min","median","max"},
///   "step_ms":{"median","p99","worst"},"peak_kb"}],
///  "ratios":[{"scene","engine","against","ratio":{"min","median","max"}}]}, and beside these: of a run "steps",
/// "busy" and "phases" (name to ms a step); "mean_ratios" and "growth". A run of a scene that an engine cannot build
/// has "unsupported" with the reason, and null for what was not measured.
std::string benchJson(std::span<const SceneBench> results);

}  // namespace plumb::compare
