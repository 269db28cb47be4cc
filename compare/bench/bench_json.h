// SPDX-License-Identifier: MIT
// How are measured times written for other programs?
#pragma once
#include <span>
#include <string>

#include <compare/bench/result.h>

namespace plumb::compare {

/// {"schema":1,"runs":[{"scene","engine","threads","bodies","ms_per_step":{"min","median","max"},"least_ms",
///   "step_ms":{"median","p99","worst"},"integrity":{"highest","overlap","joint_gap","passed_walls"},"peak_kb"}],
///  "ratios":[{"scene","engine","against","ratio":{"min","median","max"},"least"}]}
/// A run also has "steps", "repeats", "busy" and "phases" (name to ms a step). There are also "mean_ratios" of a
/// "group", and "growth". Times are processor times. ms_per_step is over the repeats; for least_ms and step_ms, each
/// step has its least time of all repeats. If an engine cannot build a scene, its run has "unsupported" with the
/// reason, and null for what was not measured.
std::string benchJson(std::span<const SceneBench> results);

}  // namespace plumb::compare
