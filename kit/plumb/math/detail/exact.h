// SPDX-License-Identifier: MIT
// Which rounding error does a sum, a difference or a product have?
#pragma once

namespace plumb {

/// A floating-point number and its rounding error: value + lost is the exact result (error-free transformation).
struct Exact {
    double value, lost;
};

/// a + b. Source: Knuth, TAOCP 2, 4.2.2, theorem B.
inline Exact exactSum(double a, double b) {
    const double value = a + b;
    const double bPart = value - a;
    return {value, (a - (value - bPart)) + (b - bPart)};
}

/// a - b, in the same way.
inline Exact exactDifference(double a, double b) {
    const double value = a - b;
    const double bPart = a - value;
    return {value, (a - (value + bPart)) + (bPart - b)};
}

/// a b, if neither is above 1e299 nor the product, when it is not 0, below 1e-290; beyond these limits lost may be NaN
/// or incomplete. Source: Veltkamp's splitting and Dekker's product, Numerische Mathematik 18, 1971.
inline Exact exactProduct(double a, double b) {
    constexpr double split = 0x1p27 + 1;
    const double aHigh = split * a - (split * a - a), aLow = a - aHigh;
    const double bHigh = split * b - (split * b - b), bLow = b - bHigh;
    const double value = a * b;
    return {value, ((aHigh * bHigh - value) + aHigh * bLow + aLow * bHigh) + aLow * bLow};
}

}  // namespace plumb
