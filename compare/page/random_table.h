// SPDX-License-Identifier: MIT
// What do the pages say about random scenes?
#pragma once
#include <span>

#include <compare/bench/result.h>
#include <compare/page/blocks.h>

namespace plumb::compare {

/// The rival's time divided by Plumb's: the means for scenes without joints and with joints, and the scenes with the
/// smallest and the largest ratios. Empty if no scene was run in both engines.
Block randomBlock(std::span<const SceneBench> results);

}  // namespace plumb::compare
