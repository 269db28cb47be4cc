// SPDX-License-Identifier: MIT
// What is the smallest oriented box around a shape?
#pragma once
#include <array>
#include <span>

#include <plumb/math/transform.h>
#include <plumb/shapes/shape.h>

namespace plumb {

/// An oriented bounding box [m].
struct OrientedBox {
    Vec2 center{0, 0};    ///< [m]
    Vec2 halfSize{0, 0};  ///< along its own axes; 0 for a line or a point [m]
    Rot rotation;         ///< of its axes
};

/// The box of smallest area around a placed shape.
/// One of its sides lies along an edge of the convex hull. As that edge advances, so do the points that the other sides
/// pass through: n steps for n corners, once they are sorted. Of boxes of equal area the first. Between two such
/// positions width and height are concave functions of the angle, so that their product, each with the diameter of the
/// rounding added, is least at an end: the rule for polygons holds for rounded polygons, too.
/// Holds: every point is in it to about eight roundings of the largest coordinate. Throws std::invalid_argument unless
/// the shape is valid for a body, and finite at its pose.
/// Source: Freeman and Shapira, "Determining the minimum-area encasing rectangle for an arbitrary closed curve", 1975;
/// Toussaint, "Solving geometric problems with the rotating calipers", 1983.
/// Test: "oriented boxes hold 100,000 shapes, and no angle of 1,000 gives a smaller one"
OrientedBox orientedBoxOf(const Shape& shape, const Transform& pose = {});

/// The same around points. Throws std::invalid_argument if there are none, or one is not finite.
OrientedBox orientedBoxOf(std::span<const Vec2> points);

/// Counter-clockwise, starting with the one at -x, -y of the box's own axes.
std::array<Vec2, 4> cornersOf(const OrientedBox& box);

/// Do they overlap or touch? Separating axis theorem: two convex polygons are separated exactly when one of the normals
/// of their edges separates them; for boxes there are four. Source: Gottschalk, Lin and Manocha, "OBBTree", SIGGRAPH
/// 1996, in two dimensions.
/// Test: "oriented boxes overlap when the distance of their polygons says so"
bool overlap(const OrientedBox& a, const OrientedBox& b);
bool contains(const OrientedBox& box, const Vec2& point);

}  // namespace plumb
