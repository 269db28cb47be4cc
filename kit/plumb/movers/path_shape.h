// SPDX-License-Identifier: MIT
// Along which lines, arcs and curves does a thing go?
#pragma once
#include <initializer_list>
#include <memory>
#include <span>
#include <vector>

#include <plumb/math/vec2.h>

namespace plumb {

/// A point of a path, and the unit vector in which the path goes on there.
struct PathPlace {
    Vec2 position{0, 0};  ///< [m]
    Vec2 tangent{1, 0};   ///< [-]
};

/// A way put together from lines, arcs and cubic curves, each from where the last one ended; where a point lies is told
/// by the way along it. For lines and arcs that is exact to rounding; for curves the way along them is told to 1e-11 of
/// their size, the length of their four points' polygon. Tests: "a path's lines and arcs are the closed forms ...",
/// "the length of 1,000 random curves ..."
class MotionPath {
public:
    // Each throws std::invalid_argument that names the parameter; the path is as it was.

    explicit MotionPath(const Vec2& start);
    MotionPath& lineTo(const Vec2& end);
    /// Around a centre, counter-clockwise for a positive angle; more than a whole turn goes round and round. Refused
    /// around the very point where the path is, and for an angle of 0.
    MotionPath& arcAround(const Vec2& center, double angle);
    /// A cubic Bezier curve, drawn towards the first of two points and coming from the second; of a size from 1e-100 to
    /// 1e100 m.
    MotionPath& curveTo(const Vec2& first, const Vec2& second, const Vec2& end);
    /// A line back to the start, unless it is there.
    MotionPath& close();

    double length() const { return length_; }  ///< [m]
    /// Is its end its start, to 1e-9 of its length?
    bool closed() const;
    const Vec2& end() const { return end_; }  ///< [m]
    /// At a way along it [m], cut to 0 to length; at a corner, the piece that begins there. Throws
    /// std::invalid_argument on one that is not finite, and when the path has no piece.
    PathPlace at(double along) const;

private:
    struct Piece;
    void add(Piece piece);

    Vec2 start_, end_;
    double length_ = 0;
    std::vector<std::shared_ptr<const Piece>> pieces_;  ///< never changed: copies of a path share them
};

/// Through all points in their order, smooth: the centripetal Catmull-Rom spline, whose curve between two points has no
/// cusp and does not cross itself. An open one leaves its ends towards their neighbours; a closed one returns to the
/// first point. Two points or more, three if it is closed, neighbours apart. Source: Catmull, Rom, "A class of local
/// interpolating splines", 1974; Yuksel, Schaefer, Keyser, "Parameterization and applications of Catmull-Rom curves",
/// 2011. Test: "1,000 random splines, open and closed, are the pyramid of Barry and Goldman, ..."
MotionPath splineThrough(std::span<const Vec2> points, bool closed = false);
MotionPath splineThrough(std::initializer_list<Vec2> points, bool closed = false);

}  // namespace plumb
