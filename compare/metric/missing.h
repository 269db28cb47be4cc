// SPDX-License-Identifier: MIT
// What stands where a number is missing?
#pragma once
#include <limits>

namespace plumb::compare {

inline constexpr double unsaid = std::numeric_limits<double>::quiet_NaN();  ///< nobody has said it
inline constexpr double unbounded =
    std::numeric_limits<double>::infinity();  ///< the error of one who should have said it, and has not

}  // namespace plumb::compare
