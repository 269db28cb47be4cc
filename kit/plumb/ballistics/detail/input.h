// SPDX-License-Identifier: MIT
// Is this number in the valid range for aiming?
#pragma once
#include <cmath>
#include <string_view>

#include <plumb/math/check.h>

namespace plumb::detail {

/// More than any game needs, and small enough that products of six are finite.
inline constexpr double largest = 1e50;

inline void requireSize(double value, std::string_view field, std::string_view member) {
    if (!(std::fabs(value) <= largest)) requireWithin(value, -largest, largest, field, member);
}

inline void requireSize(const Vec2& value, std::string_view field, std::string_view member) {
    requireSize(value.x(), field, member);
    requireSize(value.y(), field, member);
}

/// From 0 to the largest.
inline void requireAmount(double value, std::string_view field, std::string_view member) {
    if (!(value >= 0 && value <= largest)) requireWithin(value, 0, largest, field, member);
}

/// From 1 / largest to largest.
inline void requirePositiveAmount(double value, std::string_view field, std::string_view member) {
    requirePositive(value, field, member);
    requireWithin(value, 1 / largest, largest, field, member);
}

}  // namespace plumb::detail
