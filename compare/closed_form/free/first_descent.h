// SPDX-License-Identifier: MIT
// When does a polynomial first fall through zero?
#pragma once
#include <optional>
#include <vector>

namespace plumb::compare {

/// The first t in [0, end] at which c0 + c1 t + c2 t^2 + ... goes from positive to negative; 0 if it is about 0 at
/// first and falls. Empty if it never does.
/// coefficients: c0, c1, ..., in the unit of the value over powers of that of t; at least one.
/// Up to the second degree by the formula t = 2 c0 / (-c1 + sqrt(c1^2 - 4 c2 c0)), in which no digits cancel; for
/// higher degrees by bisection between the extrema, to the last bit.
/// Test: "a polynomial's first fall through zero is found, and no rise"
std::optional<double> firstDescent(const std::vector<double>& coefficients, double end);

}  // namespace plumb::compare
