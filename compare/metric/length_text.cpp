// SPDX-License-Identifier: MIT
#include <compare/metric/length_text.h>

#include <fmt/format.h>

#include <cmath>

namespace plumb::compare {

std::string lengthText(double metres) {
    if (!std::isfinite(metres)) return "infinite";
    if (std::abs(metres) < 1e-15) return "0 m";  // rounding
    if (metres < 1e-9) return fmt::format("{:.0e} m", metres);
    if (metres < 1e-6) return fmt::format("{:.3g} nm", metres * 1e9);
    if (metres < 1e-3) return fmt::format("{:.3g} µm", metres * 1e6);
    if (metres < 1) return fmt::format("{:.3g} mm", metres * 1e3);
    return fmt::format("{:.3g} m", metres);
}

}  // namespace plumb::compare
