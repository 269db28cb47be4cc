// SPDX-License-Identifier: MIT
// Which power of x does y grow with?
#pragma once
#include <optional>
#include <span>

#include <compare/lab/graph.h>

namespace plumb::compare {

/// The slope of the line through (log x, log y) with the least squares of its distances in log y: p in y = c x^p.
/// Points that are not positive and finite are left out; empty when fewer than two different x are left.
std::optional<double> exponent(std::span<const Point> points);

}  // namespace plumb::compare
