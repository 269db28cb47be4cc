// SPDX-License-Identifier: MIT
// How does a person read a length?
#pragma once
#include <fmt/format.h>

#include <cmath>
#include <string>

namespace plumb::compare {

/// In m, mm, µm or nm to three digits; as a power of ten when it is smaller still; below 1e-15 m it is 0.
inline std::string lengthText(double metres) {
    if (!std::isfinite(metres)) return "infinite";
    if (std::abs(metres) < 1e-15) return "0 m";  // rounding
    if (metres < 1e-9) return fmt::format("{:.0e} m", metres);
    if (metres < 1e-6) return fmt::format("{:.3g} nm", metres * 1e9);
    if (metres < 1e-3) return fmt::format("{:.3g} µm", metres * 1e6);
    if (metres < 1) return fmt::format("{:.3g} mm", metres * 1e3);
    return fmt::format("{:.3g} m", metres);
}

}  // namespace plumb::compare
