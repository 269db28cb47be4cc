// SPDX-License-Identifier: MIT
// Does a number fit into single precision, for an engine that uses it?
#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <compare/engine/engine.h>

namespace plumb::compare {

/// The value rounded to single precision. Throws Unsupported if the result would be infinite.
inline float toSingle(double value) {
    const auto single = static_cast<float>(value);
    if (!std::isfinite(single)) throw Unsupported(fmt::format("{} is beyond single precision", value));
    return single;
}

/// The same, but the largest number instead of an infinite one.
inline float toSingleAtMost(double value) {
    constexpr double most = std::numeric_limits<float>::max();
    return static_cast<float>(std::clamp(value, -most, most));
}

}  // namespace plumb::compare
