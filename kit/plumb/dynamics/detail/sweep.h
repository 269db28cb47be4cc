// SPDX-License-Identifier: MIT
// When do two shapes on their ways through a step come this near?
#pragma once
#include <optional>

#include <plumb/math/transform.h>
#include <plumb/shapes/shape.h>

namespace plumb {

/// How a body goes through a step, of time 0 to 1: its centre of mass straight, its angle evenly.
struct Way {
    Vec2 start{0, 0};        ///< of the centre of mass [m]
    Vec2 shift{0, 0};        ///< [m]
    double angle = 0;        ///< at the start [rad]
    double turn = 0;         ///< [rad]
    Vec2 localCenter{0, 0};  ///< of mass, in the body's frame [m]
};
Transform poseOn(const Way& way, double time);

/// One shape of a body on its way.
struct SweptShape {
    const Shape* shape = nullptr;  ///< convex: not a chain
    Way way;
    double reach = 0;  ///< farthest point from the centre of mass that turning moves along a normal [m]
};

/// The first time in [from, 1] at which the signed distance of the two is limit [m] or less, a hundredth of a
/// millimetre at most too early; empty when there is none. A search that takes too long ends at a time until which
/// there is surely none, and gives that.
/// Conservative advancement in the frame of a: with the distance s along the normal n, the speed u at which the centre
/// of b comes along n, and a bound k on how fast u may change as a turns, no approach is missed in
///   D = 2 (s - limit) / (c + sqrt(c^2 + 2 k (s - limit))), c = u + |wB - wA| reach
/// Source: Mirtich, "Impulse-based dynamic simulation of rigid body systems", 1996, section 2.3; the second-order term
/// by k from the acceleration in a turning frame.
/// Test: "a swept shape meets another when sampling ten thousand poses says so"
std::optional<double> timeWithin(const SweptShape& a, const SweptShape& b, double limit, double from);

}  // namespace plumb
