// SPDX-License-Identifier: MIT
// When do two shapes that move and turn first touch?
#pragma once
#include <optional>
#include <string>

#include <plumb/math/transform.h>
#include <plumb/shapes/shape.h>

namespace plumb {

/// The motion of a body during a step, of time 0 to 1: its centre of mass moves in a straight line, its angle changes
/// at a constant rate.
struct Sweep {
    Vec2 start{0, 0};        ///< of the centre of mass [m]
    Vec2 shift{0, 0};        ///< [m]
    double angle = 0;        ///< at the start [rad]
    double turn = 0;         ///< [rad]
    Vec2 localCenter{0, 0};  ///< of mass, in the body's frame [m]
};
Transform poseAt(const Sweep& sweep, double time);

/// Throws std::invalid_argument unless its numbers are finite and small enough for firstTouch.
void validate(const Sweep& sweep, const std::string& name);

/// The part of a sweep between two shares of its time.
Sweep partOf(const Sweep& sweep, double from, double to);

/// From one pose to another, by the shorter turn; localCenter is the point of the body's frame that moves in a straight
/// line. For a turn of more than half a revolution set Sweep.turn. Throws std::invalid_argument on a number that is not
/// finite.
Sweep sweepBetween(const Transform& start, const Transform& end, const Vec2& localCenter = {0, 0});

/// How two shapes first touch.
struct Touch {
    double time = 0;    ///< of the step, 0 to 1 [-]; of moving circles [s]
    Vec2 point{0, 0};   ///< half way between the two surfaces, in the world [m]
    Vec2 normal{0, 1};  ///< unit, from A to B [-]
};

/// When two moving shapes of any kind first touch; empty when they do not within the step. At the time returned they
/// are within tolerance [m] of each other, and before it they are never nearer than half of that: no touch is missed; a
/// touch with an approach speed u along the normal is reported at most tolerance / u too early; shapes that pass each
/// other within the tolerance may be reported as a touch. Shapes within it at the start touch at time 0; if they
/// overlap there, the normal is the direction of the shortest way out.
/// Conservative advancement. Along the normal n of the nearest points, during a time D, the two stay apart by at least
///   s(D) = min over B's corners (b + vb D - kb D^2 / 2) - max over A's corners (a + va D + ka D^2 / 2) - radii
/// b, a positions of the corners along n [m], vb, va their velocities along n [m], kb, ka = turn^2 |arm| bounds on the
/// change of these [m], arm from the centre of mass to the corner [m]; all per step. s is concave, so that a chord of
/// it ends before its zero: time advances by such chords.
/// Holds: to the rounding of distance() and of the poses; a chain is treated as its segments. A search of more than
/// 10,000 steps, such as for a shape that turns ten times at a hundredth of a millimetre from another, ends at a time
/// before which they surely do not touch, and returns that time. Throws std::invalid_argument unless the shapes are
/// valid for a body, all numbers of shapes and sweeps are finite and at most 1e75 (their fourth powers would overflow),
/// and the tolerance is positive.
/// Source: Mirtich, "Impulse-based dynamic simulation of rigid body systems", 1996, section 2.3; the bound along one
/// axis: Tang, Kim and Manocha, "C2A: controlled conservative advancement", ICRA 2009, but to second order.
/// Test: "1,000,000 swept pairs touch where fine stepping says, none missed and none made up"
std::optional<Touch> firstTouch(const Shape& a, const Sweep& sweepA, const Shape& b, const Sweep& sweepB,
                                double tolerance = 1e-5);

/// One shape of a moving body.
struct SweptShape {
    const Shape* shape = nullptr;  ///< convex: not a chain
    Sweep sweep;
    double turningRadius =
        0;  ///< largest distance from the centre of mass of a point that turning moves along a normal [m]
};

/// The first time in [from, 1] at which the signed distance of the two is limit [m] or less, at most a hundredth of a
/// millimetre too early; empty when there is none. A search with too many steps ends at a time before which there is
/// surely none, and returns that time. The engine uses this one; firstTouch answers the same question for any shapes,
/// with a sharper bound.
/// Conservative advancement in the frame of a: with the distance s along the normal n, the speed u at which the centre
/// of b approaches along n, and a bound k on how fast u may change as a turns, no approach is missed in
///   D = 2 (s - limit) / (c + sqrt(c^2 + 2 k (s - limit))), c = u + |wB - wA| turningRadius
/// Source: Mirtich, "Impulse-based dynamic simulation of rigid body systems", 1996, section 2.3; the second-order term
/// by k from the acceleration in a rotating frame.
/// Test: "a swept shape meets another when sampling ten thousand poses says so"
std::optional<double> timeOfApproach(const SweptShape& a, const SweptShape& b, double limit, double from);

}  // namespace plumb
