// SPDX-License-Identifier: MIT
// What does the front page say of speed?
#pragma once
#include <span>

#include <compare/bench/result.h>
#include <compare/page/blocks.h>

namespace plumb::compare {

/// A row a kind of scene: times in Plumb and its rival, and who is how many times as fast. Empty when one of its scenes
/// was not run in both.
Block summaryBlock(std::span<const SceneBench> results);

}  // namespace plumb::compare
