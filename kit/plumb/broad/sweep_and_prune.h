// SPDX-License-Identifier: MIT
// Which boxes overlap? Tests those whose intervals on one axis overlap: the lecture's plane sweep.
#pragma once
#include <span>

#include <plumb/broad/pair.h>
#include <plumb/shapes/aabb.h>

namespace plumb {

/// Boxes are sorted by where they begin along one axis, the axis of larger variance of their centres. A line that
/// sweeps along it reaches them in order: each box is tested against those that begin before it ends. A test is one
/// such pair, whose other axis is then compared; the comparisons of sorting are not counted.
/// For n boxes distributed evenly over a plane at constant density, tests grow as n^1.5: the side of the plane grows as
/// sqrt(n), and about sqrt(n) boxes side by side overlap on the sweep axis, although they are far apart on the other
/// one. For boxes in a row they grow as n, when the row is along the axis.
/// Source: Baraff, "Dynamic simulation of non-penetrating rigid bodies", 1992, section 2.3 (one axis); Cohen, Lin,
/// Manocha and Ponamgi, "I-COLLIDE", 1995.
/// Test: "all broad phases find equal pairs in 1,000 scenes"
PairSearch sweepAndPrunePairs(std::span<const Aabb> boxes);

}  // namespace plumb
