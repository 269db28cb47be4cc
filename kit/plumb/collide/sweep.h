// SPDX-License-Identifier: MIT
// When do two shapes that move and turn first touch?
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

/// The part of a way between two shares of it.
Way partOf(const Way& way, double from, double to);

/// From one pose to another, by the shorter turn; the point of the body's frame that goes straight is localCenter.
/// What turns by more than half a turn says so in Way.turn. Throws std::invalid_argument on what is not finite.
Way wayBetween(const Transform& start, const Transform& end, const Vec2& localCenter = {0, 0});

/// How two shapes first touch.
struct Touch {
    double time = 0;    ///< of the step, 0 to 1 [-]; of moving circles [s]
    Vec2 point{0, 0};   ///< half way between the two surfaces, in the world [m]
    Vec2 normal{0, 1};  ///< unit, from A to B [-]
};

/// When two shapes of any kind on their ways first touch; empty when they do not within the step. At the time that is
/// told they are within tolerance [m] of each other, and before it they never come nearer than half of that: no touch
/// is missed, a touch to which they come at a speed u along the normal is told tolerance / u too early at most, and
/// what passes by within the tolerance may be told as a touch. What is within it at the start touches at time 0; if it
/// overlaps there, the normal is the shortest way out.
/// Conservative advancement. Along the normal n of the nearest points, while D passes, the two stay apart by at least
///   s(D) = min over B's corners (b + vb D - kb D^2 / 2) - max over A's corners (a + va D + ka D^2 / 2) - radii
/// b, a places of the corners along n [m], vb, va their velocities along n [m], kb, ka = turn^2 |arm| bounds of how
/// these change [m], arm from the centre of mass to the corner [m]; all by the step. s is concave, so that a chord of
/// it ends before its zero: time goes on by such chords.
/// Holds: to the rounding of distance(), and of the places on the ways; a chain is its segments. A search of more than
/// 10,000 steps, as of what turns ten times a hundredth of a millimetre beside another, ends at a time before which
/// they surely do not touch, and tells that. Throws std::invalid_argument unless the shapes are ones that a body can
/// have, shapes and ways finite and no number of theirs above 1e75 (their fourth powers would overflow), and the
/// tolerance positive. Source: Mirtich, "Impulse-based dynamic simulation of rigid body systems", 1996, section 2.3;
/// the bound along one axis: Tang, Kim and Manocha, "C2A: controlled conservative advancement", ICRA 2009, but to
/// second order. Test: "1,000,000 swept pairs touch where fine stepping says, none missed and none made up"
std::optional<Touch> firstTouch(const Shape& a, const Way& wayA, const Shape& b, const Way& wayB,
                                double tolerance = 1e-5);

/// One shape of a body on its way.
struct SweptShape {
    const Shape* shape = nullptr;  ///< convex: not a chain
    Way way;
    double reach = 0;  ///< farthest point from the centre of mass that turning moves along a normal [m]
};

/// The first time in [from, 1] at which the signed distance of the two is limit [m] or less, a hundredth of a
/// millimetre at most too early; empty when there is none. A search that takes too long ends at a time until which
/// there is surely none, and gives that. What the engine asks; firstTouch asks the same of any shapes, more sharply.
/// Conservative advancement in the frame of a: with the distance s along the normal n, the speed u at which the centre
/// of b comes along n, and a bound k on how fast u may change as a turns, no approach is missed in
///   D = 2 (s - limit) / (c + sqrt(c^2 + 2 k (s - limit))), c = u + |wB - wA| reach
/// Source: Mirtich, "Impulse-based dynamic simulation of rigid body systems", 1996, section 2.3; the second-order term
/// by k from the acceleration in a turning frame.
/// Test: "a swept shape meets another when sampling ten thousand poses says so"
std::optional<double> timeWithin(const SweptShape& a, const SweptShape& b, double limit, double from);

}  // namespace plumb
