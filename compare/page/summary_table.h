// SPDX-License-Identifier: MIT
// Which few rows say in short how fast a step is?
#pragma once
#include <span>

#include <compare/bench/result.h>
#include <compare/page/blocks.h>

namespace plumb::compare {

/// One row for each kind of scene: times in Plumb and in its rival, and how many times as fast Plumb is. Empty if one
/// of the scenes was not run in both.
Block summaryBlock(std::span<const SceneBench> results);

}  // namespace plumb::compare
