// SPDX-License-Identifier: MIT
// Which boxes overlap? Asked of those that share a stretch of one axis: the lecture's plane sweep.
#pragma once
#include <span>

#include <plumb/broad/pair.h>
#include <plumb/shapes/aabb.h>

namespace plumb {

/// Boxes are sorted by where they begin along one axis, that along which their centres vary more. A line that sweeps
/// along it comes to them in order: each is tested against those that begin before it ends.
/// A test is one such pair, whose other axis is then compared; the comparisons of sorting are not counted.
/// Of n boxes that lie evenly over a plane at constant density, tests grow as n^1.5: the side of the plane grows as
/// sqrt(n), and all sqrt(n) or so that lie across it share each stretch, as the other axis is not looked at before.
/// Of boxes in a row they grow as n, when the row is the axis.
/// Source: Baraff, "Dynamic simulation of non-penetrating rigid bodies", 1992, section 2.3 (one axis); Cohen, Lin,
/// Manocha and Ponamgi, "I-COLLIDE", 1995. Test: "all broad phases find equal pairs in 1,000 scenes"
PairSearch sweepAndPrunePairs(std::span<const Aabb> boxes);

}  // namespace plumb
