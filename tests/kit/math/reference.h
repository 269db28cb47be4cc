// SPDX-License-Identifier: MIT
// How often, and against what, are approximated functions measured?
#pragma once
#include <limits>

namespace plumb::test {

inline constexpr int million = 1'000'000;

/// The reference's own error, in a double's last places: with 11 bits more than a double, or 60, as good as none. Where
/// long double is no longer than double it is up to 1.
inline constexpr double own = std::numeric_limits<long double>::digits >= 64 ? 1e-3 : 1;

}  // namespace plumb::test
