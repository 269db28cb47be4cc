// SPDX-License-Identifier: MIT
// What do pages say of random scenes?
#pragma once
#include <span>

#include <compare/bench/result.h>
#include <compare/page/blocks.h>

namespace plumb::compare {

/// The rival over Plumb: means of those without joints and with, and the scenes in which it is least and most. Empty
/// when none was run in both.
Block randomBlock(std::span<const SceneBench> results);

}  // namespace plumb::compare
