// SPDX-License-Identifier: MIT
// Where between two positive numbers does a function change its sign?
#pragma once
#include <cmath>

namespace plumb::detail {

struct ValueAndSlope {
    double value, slope;
};

/// To the last digits. f(x) returns value and slope and has opposite signs at low and high; lowIsPositive tells which;
/// 0 < low < high. Newton's method; where it leaves the bracket or converges slowly, bisection of the exponents
/// (geometric mean): so it converges for any f. Source: Press et al., "Numerical Recipes", 9.4, rtsafe.
template <typename Function>
double rootBetween(double low, double high, bool lowIsPositive, const Function& f) {
    double last = high - low;
    double x = std::sqrt(low) * std::sqrt(high);
    for (int i = 0; i < 200; ++i) {
        if (!(x > low && x < high)) break;
        const ValueAndSlope at = f(x);
        if (at.value == 0) break;
        ((at.value > 0) == lowIsPositive ? low : high) = x;
        double next = x - at.value / at.slope;
        if (!(next >= low && next <= high && std::fabs(next - x) < 0.5 * last)) next = std::sqrt(low) * std::sqrt(high);
        last = std::fabs(next - x);
        if (last <= 1e-16 * x) break;
        x = next;
    }
    return x;
}

}  // namespace plumb::detail
