// SPDX-License-Identifier: MIT
// Where does a shot with quadratic drag cross the straight line to its target?
#pragma once
#include <optional>

namespace plumb::detail {

/// In units of v^2 / g for lengths and v / g for times, v the speed at the launch; gravity is down, and the line goes
/// to the right with a given slope.
struct Crossing {
    double across = 0;       ///< x of the crossing
    double acrossSlope = 0;  ///< its derivative with respect to the slope of the launch
    double time = 0;
};

/// For a shot launched with a slope above that of the line by steeper > 0. strength = 2 c v^2 / g.
///   x = int cosh s / W ds,  y = int sinh s cosh s / W ds,  t = int cosh s / sqrt(W) ds,  from s1 to s0
///   W = cosh^2 s0 + strength (f(s0) - f(s)),  f(s) = sinh(2 s) / 4 + s / 2
/// s slope of the path as arsinh [-], s0 at the launch, s1 at the crossing, W (v / x')^2 [-], c coefficient [1/m]
/// Source: the hodograph of Johann Bernoulli, 1719: with p = sinh s, x'' = -c |u| x' and p' = -g / x' give d(1 / x'^2)
/// / dp = -2 c / g sqrt(1 + p^2). The integrals use Gauss quadrature of 8 points on panels over which W changes little;
/// their derivatives with respect to the launch slope are computed together with them.
std::optional<Crossing> crossingOf(double line, double steeper, double strength);

}  // namespace plumb::detail
