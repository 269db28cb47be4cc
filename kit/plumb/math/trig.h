// SPDX-License-Identifier: MIT
// What are sine, cosine, arc tangent and exponential, with the same bits on every machine?
// The C library's results differ between platforms in the last bit; these use only +, -, *, / and rounding, which do
// not. Their names differ from the C library's, so that a program may be using namespace plumb together with <cmath>.
#pragma once

namespace plumb {

struct SinCos {
    double sin = 0, cos = 1;
};

/// Sine and cosine of an angle [rad], NaN if it is not finite. Error below 1 unit in the last place for |angle| up to
/// 1e7, below 1e-16 up to 3.5e13; beyond that, where neighbouring doubles differ by a hundredth, below 4e-17 |angle|.
/// Source: range reduction by Cody and Waite, then Taylor's series. Test: "sine and cosine are within 1 ulp ..."
SinCos sinCos(double angle);

/// Angle of the vector (x, y) from +x, in (-pi, pi] [rad]; 0 for the zero vector, NaN if a coordinate is not finite.
/// Error below 4e-16, and below 1.5 units in the last place. The sign of zero is ignored: arcTangent(-0.0, -1) is pi.
double arcTangent(double y, double x);

/// e^x; error below 1 unit in the last place. Overflows to infinity and underflows to 0 as std::exp does.
double exponential(double x);

/// e^x - 1 without cancellation near 0; error below 1.5 units in the last place.
double exponentialMinus1(double x);

}  // namespace plumb
