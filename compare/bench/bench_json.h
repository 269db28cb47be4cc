// SPDX-License-Identifier: MIT
// How do measured times look to a program?
#pragma once
#include <span>
#include <string>

#include <compare/bench/result.h>

namespace plumb::compare {

/// {"schema":1,"runs":[{"scene","engine","threads","bodies","ms_per_step":{"min","median","max"},"least_ms",
///   "step_ms":{"median","p99","worst"},"integrity":{"highest","overlap","joint_gap","passed_walls"},"peak_kb"}],
///  "ratios":[{"scene","engine","against","ratio":{"min","median","max"},"least"}]}, and beside these: of a run
///  "steps",
/// "repeats", "busy" and "phases" (name to ms a step); "mean_ratios" of a "group", and "growth". Times are processor
/// times. ms_per_step is over the repeats; in least_ms and step_ms, each step has its least time of the repeats. A run
/// of a scene that an engine cannot build has "unsupported" with the reason, and null for what was not measured.
std::string benchJson(std::span<const SceneBench> results);

}  // namespace plumb::compare
