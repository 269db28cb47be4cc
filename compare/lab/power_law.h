// SPDX-License-Identifier: MIT
// With which power of x does y grow?
#pragma once
#include <optional>
#include <span>

#include <compare/lab/graph.h>

namespace plumb::compare {

/// The exponent p in y = c x^p: the slope of the least-squares line through (log x, log y), with distances in log y.
/// Points that are not positive and finite are left out. Empty if fewer than two different x are left.
std::optional<double> exponent(std::span<const Point> points);

}  // namespace plumb::compare
