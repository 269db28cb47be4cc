// SPDX-License-Identifier: MIT
// What stands where a number is missing?
#pragma once
#include <limits>

namespace plumb::compare {

inline constexpr double unsaid = std::numeric_limits<double>::quiet_NaN();  ///< not known, and nobody has to know it
inline constexpr double unbounded =
    std::numeric_limits<double>::infinity();  ///< the error of an engine that has to know it and does not

}  // namespace plumb::compare
