// SPDX-License-Identifier: MIT
// Which quantities of a motion with constant acceleration follow from three known ones?
#pragma once
#include <optional>
#include <vector>

#include <plumb/kinematics/point_motion.h>

namespace plumb {

/// The known quantities of a motion along one axis: three of the five. For a rotation, read angle for displacement, and
/// so on.
struct KnownMotion {
    std::optional<double> displacement = std::nullopt;   ///< d, from where it was at the start [m]
    std::optional<double> startVelocity = std::nullopt;  ///< u [m/s]
    std::optional<double> endVelocity = std::nullopt;    ///< v [m/s]
    std::optional<double> acceleration = std::nullopt;   ///< a [m/s^2]
    std::optional<double> time = std::nullopt;           ///< t, from start to end [s]
};

struct SolvedMotion {
    double displacement = 0, startVelocity = 0, endVelocity = 0, acceleration = 0, time = 0;  ///< as in KnownMotion
};

struct MotionSolutions {
    std::vector<SolvedMotion> motions;  ///< at most two, the earlier first; none if there is a contradiction
    bool infinitelyMany = false;        ///< the known quantities leave one undetermined; then motions is empty
};

/// Which times count as a solution. With NotNegative a given time below 0 has no solution: the result is empty, and
/// nothing is thrown.
enum class MotionTimes { NotNegative, AnyReal };

/// v = u + a t,  d = u t + a t^2 / 2 = (u + v) t / 2,  v^2 = u^2 + 2 a d;  symbols and units as in KnownMotion.
/// All real solutions, each quantity within four units in its last place; the number of solutions is exact as well.
/// Magnitudes should be 0 or from 1e-90 to 1e90: outside of that, digits may be lost, and solutions that are not
/// finite, or overflow on the way.
/// Throws std::invalid_argument unless three are given, each finite. Source: textbook; the quadratic by its larger root
/// and the product of the two (Press et al., "Numerical Recipes", 5.6), its discriminant with the exact products after
/// Kahan. Tests: "1,000,000 motions are found again from any three of their five numbers", "each of 10,000,000 answers
/// is within four of its last place of the textbook's in long double"
MotionSolutions solveMotion(const KnownMotion& known, MotionTimes times = MotionTimes::NotNegative);

/// The same in the plane, with given time: then two of the four vectors determine the others.
struct KnownPlaneMotion {
    std::optional<Vec2> displacement = std::nullopt;   ///< [m]
    std::optional<Vec2> startVelocity = std::nullopt;  ///< [m/s]
    std::optional<Vec2> endVelocity = std::nullopt;    ///< [m/s]
    std::optional<Vec2> acceleration = std::nullopt;   ///< [m/s^2]
    double time = 0;                                   ///< of either sign [s]
};

struct SolvedPlaneMotion {
    Vec2 displacement, startVelocity, endVelocity, acceleration;  ///< as in KnownPlaneMotion
    double time = 0;                                              ///< [s]
};

struct PlaneMotionSolution {
    std::optional<SolvedPlaneMotion> motion;  ///< empty when there is none, or infinitely many
    bool infinitelyMany = false;
};

/// Each axis by solveMotion, with a time of either sign.
/// Throws std::invalid_argument unless two vectors are given, all finite, and a finite time.
/// Test: "a motion in the plane is that of its axes"
PlaneMotionSolution solveMotion(const KnownPlaneMotion& known);

/// x = x0 + v0 t + a t^2 / 2, v = v0 + a t: exact for any t, so any number of steps leads to the same state.
/// x position [m], v velocity [m/s], a acceleration [m/s^2], t time, of either sign [s]. Source: textbook.
/// Throws std::invalid_argument on a number that is not finite. Test: "a motion in steps is the motion at once"
PointMotion moveAccelerated(const PointMotion& from, const Vec2& acceleration, double time);

}  // namespace plumb
