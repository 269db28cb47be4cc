// SPDX-License-Identifier: MIT
#include <plumb/math/logarithm.h>

#include <array>
#include <cmath>
#include <limits>

namespace plumb {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

// 2 (s^2 / 3 + s^4 / 5 + ...) up to s^22: the next term is below 3e-18 of the logarithm at |s| = 0.1716.
double seriesOf(double s) {
    constexpr std::array<double, 11> series = {2.0 / 3,  2.0 / 5,  2.0 / 7,  2.0 / 9,  2.0 / 11, 2.0 / 13,
                                               2.0 / 15, 2.0 / 17, 2.0 / 19, 2.0 / 21, 2.0 / 23};
    const double z = s * s;
    double sum = series.back();
    for (std::size_t k = series.size() - 1; k-- > 0;) sum = sum * z + series[k];
    return sum * z;
}

struct Split {
    double part;   ///< in [sqrt(1/2), sqrt(2))
    int exponent;  ///< x = 2^exponent part
};

Split split(double x) {
    Split result{};
    result.part = std::frexp(x, &result.exponent);
    if (result.part < 0x1.6a09e667f3bcdp-1) {
        result.part *= 2;
        --result.exponent;
    }
    return result;
}

// ln(2^exponent (1 + f)) + lost, where lost is so small that its square is negligible.
double sum(double f, int exponent, double lost) {
    constexpr double ln2High = 0x1.62e42fefa2p-1;  // 40 bits: exact when multiplied by an exponent of at most 11 bits
    constexpr double ln2Low = 0x1.9ef35793c7673p-41;
    const double half = 0.5 * f * f;
    const double s = f / (2 + f);
    const double tail = s * (half + seriesOf(s));
    return exponent * ln2High + (f - (half - (tail + (exponent * ln2Low + lost))));
}

}  // namespace

double logarithm(double x) {
    if (x == 0) return -infinity;
    if (!(x > 0)) return notANumber;
    if (x == infinity) return x;
    const Split at = split(x);
    return sum(at.part - 1, at.exponent, 0);
}

double logarithm1Plus(double x) {
    if (x == -1) return -infinity;
    if (!(x > -1)) return notANumber;
    if (x == infinity) return x;
    if (std::fabs(x) < 0x1p-54) return x;
    if (x > -0.29 && x < 0.41) return sum(x, 0, 0);
    const double whole = 1 + x;
    const double lost = x < 1 ? x - (whole - 1) : 1 - (whole - x);
    const Split at = split(whole);
    return sum(at.part - 1, at.exponent, lost / whole);
}

}  // namespace plumb
