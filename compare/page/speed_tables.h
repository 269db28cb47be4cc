// SPDX-License-Identifier: MIT
// What do the pages say about the speed of each engine?
#pragma once
#include <span>
#include <vector>

#include <compare/bench/result.h>
#include <compare/page/blocks.h>

namespace plumb::compare {

/// The blocks for which there are results:
///   speed      a row for each scene, without random ones and those that only differ in size; how it was measured; the
///              mean
///   integrity  what the engines did in these scenes
///   random     random scenes: means, with joints and without, and the rows that are farthest from the mean
///   growth     how times grow with the number of bodies
///   phases     how much time each part of Plumb's step takes
///   summary    one row for each kind of scene, in short, if all of its scenes were run
///   jointed    the same for the scenes of the group jointed, with the gaps of their joints
/// Throws std::invalid_argument if Plumb or its rival was not run.
std::vector<Block> speedBlocks(std::span<const SceneBench> results);

/// The rival's time divided by Plumb's: the means for scenes without joints and with joints, and the scenes with the
/// smallest and the largest ratios. Empty if no scene was run in both engines.
Block randomBlock(std::span<const SceneBench> results);

/// One row for each kind of scene: times in Plumb and in its rival, and how many times as fast Plumb is. Empty if one
/// of the scenes was not run in both.
Block summaryBlock(std::span<const SceneBench> results);
Block jointedBlock(std::span<const SceneBench> results);

}  // namespace plumb::compare
