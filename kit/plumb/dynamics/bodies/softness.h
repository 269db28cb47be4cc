// SPDX-License-Identifier: MIT
// How firmly does a soft constraint correct a position?
#pragma once

namespace plumb {

/// A constraint as a damped spring, solved implicitly over a sub-step h:
///   biasRate = w / (2 z + h w), massScale = h w (2 z + h w) / (1 + h w (2 z + h w)), impulseScale = 1 - massScale
/// w = 2 pi frequency [rad/s], z damping ratio [-], h sub-step [s]
/// Source: Catto, "Soft constraints", GDC 2011; the form without stiffness: "Solver2D", 2024.
struct Softness {
    float biasRate = 0;      ///< [1/s]
    float massScale = 1;     ///< [-]
    float impulseScale = 0;  ///< [-]
};

inline Softness softness(double frequency, double dampingRatio, double h) {
    const double w = 2 * 3.14159265358979323846 * frequency;
    const double a = 2 * dampingRatio + h * w;
    const double b = h * w * a;
    return {static_cast<float>(w / a), static_cast<float>(b / (1 + b)), static_cast<float>(1 / (1 + b))};
}

}  // namespace plumb
