// SPDX-License-Identifier: MIT
// Which boxes overlap? Asked of every pair: the reference for the other broad phases.
#pragma once
#include <span>

#include <plumb/broad/pair.h>
#include <plumb/shapes/aabb.h>

namespace plumb {

SortedPairs bruteForcePairs(std::span<const Aabb> boxes);

}  // namespace plumb
