// SPDX-License-Identifier: MIT
// Which boxes overlap? Tests every pair: the reference for the other broad phases.
#pragma once
#include <span>

#include <plumb/broad/pair.h>
#include <plumb/shapes/aabb.h>

namespace plumb {

/// Tests every two of n boxes: n (n - 1) / 2 tests.
PairSearch bruteForcePairs(std::span<const Aabb> boxes);

}  // namespace plumb
