// SPDX-License-Identifier: MIT
// In which shape does a chain of links hang between two hooks?
#pragma once
#include <vector>

#include <plumb/math/vec2.h>

namespace plumb::compare {

/// Equal links, each with its centre of mass in its middle, between hooks at the same height.
struct HungChain {
    Vec2 left{0, 0};           ///< the left hook [m]
    double span = 1;           ///< to the right hook, > 0 and less than the chain's length [m]
    int links = 20;            ///< [-]
    double linkLength = 0.25;  ///< [m]
};

/// The hinges, from the left hook to the right one: links + 1 points.
/// Link i = 0 .. n - 1 rises at (i + 1/2 - n/2) / H, with H such that the links span the hooks.
/// H is the horizontal pull over a link's weight [-]. A link's ends carry (i - n/2) and (i + 1 - n/2) weights, and the
/// link lies along the mean of their pulls. Source: statics; for many short links the catenary y = H cosh(x / H). H is
/// found by bisection to the last bit. Test: "a chain of many links hangs as a catenary"
std::vector<Vec2> hingesOf(const HungChain& chain);

}  // namespace plumb::compare
