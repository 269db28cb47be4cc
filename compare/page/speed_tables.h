// SPDX-License-Identifier: MIT
// What do pages say of how fast each engine is?
#pragma once
#include <span>
#include <vector>

#include <compare/bench/result.h>
#include <compare/page/blocks.h>

namespace plumb::compare {

/// The blocks that results have something to say about:
///   speed      a row a scene, but for random ones and those that only differ in size; how it was measured; the mean
///   integrity  what the engines did in these scenes
///   random     random scenes: means, with joints and without, and the rows that are farthest from the mean
///   growth     how times grow with the number of bodies
///   phases     where a step of Plumb's goes
///   summary    one row a kind of scene, for the front page, where all of its scenes were run
/// Throws std::invalid_argument where Plumb was not run, or not with its rival beside it.
std::vector<Block> speedBlocks(std::span<const SceneBench> results);

}  // namespace plumb::compare
