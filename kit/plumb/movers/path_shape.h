// SPDX-License-Identifier: MIT
// Of which lines, arcs and curves does a path consist?
#pragma once
#include <initializer_list>
#include <memory>
#include <span>
#include <vector>

#include <plumb/math/vec2.h>

namespace plumb {

/// A point of a path, and its unit tangent.
struct PathPlace {
    Vec2 position{0, 0};  ///< [m]
    Vec2 tangent{1, 0};   ///< [-]
};

/// A path of lines, arcs and cubic curves, each starting where the one before ended; points are found by arc length.
/// For lines and arcs that is exact to rounding; for curves the arc length is accurate to 1e-11 of their size, the
/// length of their control polygon. Tests: "a path's lines and arcs are the closed forms ...", "the length of 1,000
/// random curves ..."
class MotionPath {
public:
    // Each throws std::invalid_argument that names the parameter, and leaves the path as it was.

    explicit MotionPath(const Vec2& start);
    MotionPath& lineTo(const Vec2& end);
    /// Around a centre, counter-clockwise for a positive angle; more than a full turn is allowed. Refused if the centre
    /// is the present end of the path, and for an angle of 0.
    MotionPath& arcAround(const Vec2& center, double angle);
    /// A cubic Bezier curve with these control points; its size must be from 1e-100 to 1e100 m.
    MotionPath& curveTo(const Vec2& first, const Vec2& second, const Vec2& end);
    /// A line back to the start, unless the path ends there.
    MotionPath& close();

    double length() const { return length_; }  ///< [m]
    /// Is its end equal to its start, to 1e-9 of its length?
    bool closed() const;
    const Vec2& end() const { return end_; }  ///< [m]
    /// The point at an arc length [m], which is limited to 0 to length; at a corner, the piece that begins there.
    /// Throws std::invalid_argument on a length that is not finite, and when the path is empty.
    PathPlace at(double along) const;

private:
    struct Piece;
    void add(Piece piece);

    Vec2 start_, end_;
    double length_ = 0;
    std::vector<std::shared_ptr<const Piece>> pieces_;  ///< immutable: copies of a path share them
};

/// A smooth curve through all points in order: the centripetal Catmull-Rom spline, whose curve between two points has
/// no cusp and does not intersect itself. At the ends of an open spline the curve starts towards the neighbouring
/// point; a closed one returns to the first point. Two points or more, three if it is closed; neighbours must differ.
/// Source: Catmull, Rom, "A class of local interpolating splines", 1974; Yuksel, Schaefer, Keyser, "Parameterization
/// and applications of Catmull-Rom curves", 2011.
/// Test: "1,000 random splines, open and closed, are the pyramid of Barry and Goldman, ..."
MotionPath splineThrough(std::span<const Vec2> points, bool closed = false);
MotionPath splineThrough(std::initializer_list<Vec2> points, bool closed = false);

}  // namespace plumb
