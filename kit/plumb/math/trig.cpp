// SPDX-License-Identifier: MIT
#include <plumb/math/trig.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include <plumb/math/detail/exact.h>

namespace plumb {
namespace {

constexpr double noAngle = std::numeric_limits<double>::quiet_NaN();

// Adding and subtracting 1.5 * 2^52 rounds to an integer: exact for |x| < 2^51, and without a library call.
double nearestInteger(double x) {
    constexpr double shift = 0x1.8p52;
    return (x + shift) - shift;
}

// pi / 2 split into parts of 26 bits (the last has 53): the product of an integer of 26 bits with each of the first
// four is exact.
constexpr std::array<double, 5> halfPiPieces = {0x1.921fb5p+0, 0x1.110b46p-26, 0x1.1a6263p-54, 0x1.8a2e03p-81,
                                                0x1.c1cd129024e09p-107};
constexpr double twoOverPi = 0x1.45f306dc9c883p-1;
constexpr double twoPi = 0x1.921fb54442d18p+2;

Exact minusQuarterTurns(Exact angle, double count) {
    double low = angle.lost;
    double high = angle.value;
    for (const double piece : halfPiPieces) {
        const Exact rest = exactDifference(high, count * piece);
        high = rest.value;
        low += rest.lost;
    }
    return {high, low};
}

struct Reduced {
    Exact angle;       ///< in [-pi/4, pi/4], or slightly outside [rad]
    unsigned quarter;  ///< quarter turns to add, modulo 4
};

// Source: Cody and Waite, "Software Manual for the Elementary Functions", 1980, with the pieces summed error-free.
Reduced reduce(double angle) {
    // Above 2^45 neighbouring doubles differ by more than a hundredth; the library's remainder is exact by definition,
    // and only the error of 2 pi as a double remains.
    const double within = std::fabs(angle) < 0x1p45 ? angle : std::remainder(angle, twoPi);
    const double count = nearestInteger(within * twoOverPi);
    if (count == 0) return {{within, 0}, 0};
    const double countHigh = nearestInteger(count * 0x1p-26) * 0x1p26;
    Exact rest{within, 0};
    if (countHigh != 0) rest = minusQuarterTurns(rest, countHigh);
    rest = minusQuarterTurns(rest, count - countHigh);
    const double sum = rest.value + rest.lost;
    return {{sum, rest.lost - (sum - rest.value)}, static_cast<unsigned>(static_cast<std::int64_t>(count) & 3)};
}

// The sum of coefficients[k] z^k (Horner's scheme).
template <std::size_t N>
double polynomial(const std::array<double, N>& coefficients, double z) {
    double sum = coefficients[N - 1];
    for (std::size_t k = N - 1; k-- > 0;) sum = sum * z + coefficients[k];
    return sum;
}

// Taylor's series up to x^17: the next term is below 1e-19 of x at pi / 4.
double sineOf(const Exact& x) {
    constexpr std::array<double, 8> series = {
        -1.0 / 6,        1.0 / 120,        -1.0 / 5040,          1.0 / 362880,
        -1.0 / 39916800, 1.0 / 6227020800, -1.0 / 1307674368000, 1.0 / 355687428096000};
    const double z = x.value * x.value;
    return x.value + (x.value * z * polynomial(series, z) + x.lost * (1 - 0.5 * z));
}

// Taylor's series up to x^16: the next term is below 3e-18 at pi / 4.
double cosineOf(const Exact& x) {
    constexpr std::array<double, 7> series = {1.0 / 24,        -1.0 / 720,         1.0 / 40320,         -1.0 / 3628800,
                                              1.0 / 479001600, -1.0 / 87178291200, 1.0 / 20922789888000};
    const double z = x.value * x.value;
    const double half = 0.5 * z;
    const double start = 1 - half;
    return start + (((1 - start) - half) + (z * z * polynomial(series, z) - x.value * x.lost));
}

// atan(u) for |u| <= 1/16. The series up to u^13: the next term is below 1e-18 of u.
double smallArcTangent(double u) {
    constexpr std::array<double, 6> series = {-1.0 / 3, 1.0 / 5, -1.0 / 7, 1.0 / 9, -1.0 / 11, 1.0 / 13};
    const double z = u * u;
    return u * z * polynomial(series, z);
}

// atan(i / 8) and the rounding error of that value.
constexpr std::array<Exact, 9> arcTangents = {{{0, 0},
                                               {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
                                               {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
                                               {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
                                               {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
                                               {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
                                               {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
                                               {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
                                               {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}}};

// atan(n / d) = atan(c) + atan((n - c d) / (d + c n)), with c the multiple of 1/8 next to n / d; 0 <= n <= d, 0 < d.
Exact firstOctant(double n, double d) {
    const double step = nearestInteger(8 * (n / d));
    const double c = step / 8;
    const double u = step == 0 ? n / d : (n - c * d) / (d + c * n);
    const Exact base = arcTangents[static_cast<std::size_t>(step)];
    const double tail = smallArcTangent(u) + base.lost;
    const double high = base.value + u;
    return {high, (u - (high - base.value)) + tail};
}

// 1/2!, 1/3!, ...: (e^x - 1 - x) / x^2 up to x^13 of e^x; the next term is below 5e-18 at ln(2) / 2.
double expTail(double x) {
    constexpr std::array<double, 12> series = {1.0 / 2,       1.0 / 6,        1.0 / 24,        1.0 / 120,
                                               1.0 / 720,     1.0 / 5040,     1.0 / 40320,     1.0 / 362880,
                                               1.0 / 3628800, 1.0 / 39916800, 1.0 / 479001600, 1.0 / 6227020800};
    return x * x * polynomial(series, x);
}

struct PowerOfTwo {
    double rest;      ///< within [-ln 2 / 2, ln 2 / 2]
    double lost;      ///< rounding error of rest
    double exponent;  ///< x = exponent ln 2 + rest + lost
};

PowerOfTwo splitPower(double x) {
    constexpr double log2e = 0x1.71547652b82fep+0;
    constexpr double ln2High = 0x1.62e42fefa2p-1;  // 40 bits: exact when multiplied by an exponent of at most 11 bits
    constexpr double ln2Low = 0x1.9ef35793c7673p-41;
    const double exponent = nearestInteger(x * log2e);
    const double high = x - exponent * ln2High;
    const double low = exponent * ln2Low;
    const double rest = high - low;
    return {rest, (high - rest) - low, exponent};
}

}  // namespace

SinCos sinCos(double angle) {
    if (!std::isfinite(angle)) return {noAngle, noAngle};
    const Reduced r = reduce(angle);
    const double sine = sineOf(r.angle);
    const double cosine = cosineOf(r.angle);
    switch (r.quarter) {
        case 0: return {sine, cosine};
        case 1: return {cosine, -sine};
        case 2: return {-sine, -cosine};
        default: return {-cosine, sine};
    }
}

double arcTangent(double y, double x) {
    if (!std::isfinite(x) || !std::isfinite(y)) return noAngle;
    double across = std::fabs(x);
    double up = std::fabs(y);
    if (across == 0 && up == 0) return 0;
    const bool steep = up > across;
    const double larger = steep ? up : across;
    const double scale = larger > 0x1p1000 ? 0x1p-100 : larger < 0x1p-900 ? 0x1p150 : 1;
    across *= scale;
    up *= scale;
    Exact angle = steep ? firstOctant(across, up) : firstOctant(up, across);
    constexpr Exact halfPi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
    if (steep)
        angle = {halfPi.value - angle.value,
                 halfPi.lost - angle.lost + exactDifference(halfPi.value, angle.value).lost};
    if (x < 0) {
        const Exact rest = exactDifference(2 * halfPi.value, angle.value);
        angle = {rest.value, rest.lost + (2 * halfPi.lost - angle.lost)};
    }
    const double size = angle.value + angle.lost;
    return y < 0 ? -size : size;
}

double exponential(double x) {
    if (std::isnan(x)) return x;
    if (x > 710) return std::numeric_limits<double>::infinity();
    if (x < -746) return 0;
    const PowerOfTwo p = splitPower(x);
    return std::ldexp(1 + (p.rest + (p.lost + expTail(p.rest))), static_cast<int>(p.exponent));
}

double exponentialMinus1(double x) {
    if (std::isnan(x)) return x;
    if (x > 710) return std::numeric_limits<double>::infinity();
    if (x < -45) return -1;
    const PowerOfTwo p = splitPower(x);
    const double tail = p.lost + expTail(p.rest);
    if (p.exponent == 0) return p.rest + tail;
    const int exponent = static_cast<int>(p.exponent);
    // 2^k (1 + s) - 1 = 2^k ((1 - 2^-k) + s)
    return std::ldexp(((1 - std::ldexp(1, -exponent)) + p.rest) + tail, exponent);
}

}  // namespace plumb
