// SPDX-License-Identifier: MIT
// What is the natural logarithm, to the same bits on every machine?
// As in trig.h: only +, -, *, / and exact scaling by powers of two, and names that differ from the C library's.
#pragma once

namespace plumb {

/// ln x; error below 1 unit in the last place. -infinity at 0, NaN below it and for NaN, infinity at infinity.
///   ln(2^k (1 + f)) = k ln 2 + f - (f^2 / 2 - s (f^2 / 2 + r))
///   s = f / (2 + f),  r = 2 (s^2 / 3 + s^4 / 5 + ...)
/// k exponent [-], 1 + f within [sqrt(1/2), sqrt(2)) [-]
/// Source: the series of artanh s; the order of summation is that of Sun's fdlibm (Ng, 1993).
/// Test: "a million logarithms are within 1 ulp, and with 1 added first"
double logarithm(double x);

/// ln(1 + x) without cancellation near 0; error below 1 unit in the last place. -infinity at -1, NaN below it and for
/// NaN.
double logarithm1Plus(double x);

}  // namespace plumb
