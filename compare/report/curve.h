// SPDX-License-Identifier: MIT
// How is a long series drawn with few points without losing its peaks?
#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace plumb::compare {

/// How many ticks share a pair of points, so that `ticks` ticks give about `most` points. 1 means that each tick has
/// its own point; else the number is even.
std::size_t curveStride(std::size_t ticks, std::size_t most);

/// Stride 1: the series itself. Else two points for every `stride` ticks: the smallest and the largest of their values,
/// the earlier one first. NaN is skipped, and is used only if there is no other value.
/// Point j is at tick floor(j / 2) stride + (j mod 2) stride / 2.
std::vector<double> thinned(std::span<const double> series, std::size_t stride);

}  // namespace plumb::compare
