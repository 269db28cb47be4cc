// SPDX-License-Identifier: MIT
#include <plumb/integrate/integrate.h>

#include <cmath>

namespace plumb {
namespace {

bool counts(int signBefore, ZeroCrossing crossing) {
    if (crossing == ZeroCrossing::Rising) return signBefore < 0;
    if (crossing == ZeroCrossing::Falling) return signBefore > 0;
    return signBefore != 0;
}

// The first number at which the quantity no longer has the sign it has at low.
double bisected(const std::function<double(double)>& quantity, double low, double high, int sign) {
    for (;;) {
        const double middle = 0.5 * (low + high);
        if (middle <= low || middle >= high) return high;
        (sign * quantity(middle) > 0 ? low : high) = middle;
    }
}

}  // namespace

CrossingSearch findCrossing(const std::function<double(double)>& quantity, int signBefore, ZeroCrossing crossing) {
    constexpr int samples = 8;
    int sign = signBefore;
    for (int i = 1; i <= samples; ++i) {
        const double value = quantity(static_cast<double>(i) / samples);
        const bool crosses = value == 0 || sign * value < 0;
        if (crosses && counts(sign, crossing))
            return {bisected(quantity, static_cast<double>(i - 1) / samples, static_cast<double>(i) / samples, sign),
                    sign};
        if (value != 0 && !std::isnan(value)) sign = value > 0 ? 1 : -1;
    }
    return {{}, sign};
}

}  // namespace plumb
