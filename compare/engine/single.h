// SPDX-License-Identifier: MIT
// Does a number fit an engine that computes in single precision?
#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <compare/engine/engine.h>

namespace plumb::compare {

/// Rounded to single precision. Throws Unsupported when that would be infinite.
inline float toSingle(double value) {
    const auto single = static_cast<float>(value);
    if (!std::isfinite(single)) throw Unsupported(fmt::format("{} is beyond single precision", value));
    return single;
}

/// The same, but what would be infinite becomes the largest number there is.
inline float toSingleAtMost(double value) {
    constexpr double most = std::numeric_limits<float>::max();
    return static_cast<float>(std::clamp(value, -most, most));
}

}  // namespace plumb::compare
