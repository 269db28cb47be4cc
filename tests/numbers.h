// SPDX-License-Identifier: MIT
// Which numbers stand in many tests?
#pragma once
#include <limits>
#include <numbers>

namespace plumb::test {

inline constexpr double pi = std::numbers::pi;
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace plumb::test
