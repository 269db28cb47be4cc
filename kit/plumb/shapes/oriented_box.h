// SPDX-License-Identifier: MIT
// Which is the smallest box, turned as it may be, that holds a shape?
#pragma once
#include <array>
#include <span>

#include <plumb/math/transform.h>
#include <plumb/shapes/shape.h>

namespace plumb {

/// An oriented bounding box [m].
struct OrientedBox {
    Vec2 center{0, 0};    ///< [m]
    Vec2 halfSize{0, 0};  ///< along its own axes; 0 is a line or a point [m]
    Rot rotation;         ///< of its axes
};

/// Of smallest area, around a placed shape.
/// One of its sides lies along an edge of the convex hull; the points that the other sides go through follow, one after
/// the other, as that edge goes round: n steps for n corners, once they are sorted. Of boxes equally small the first.
/// Between two such positions width and height are concave functions of the angle, so that the product of the two, each
/// with the diameter of a rounding added, is least at an end: what holds of polygons holds of rounded ones.
/// Holds: every point lies in it to about eight roundings of the largest coordinate. Throws std::invalid_argument
/// unless the shape is one that a body can have, and finite where it lies. Source: Freeman and Shapira, "Determining
/// the minimum-area encasing rectangle for an arbitrary closed curve", 1975; Toussaint, "Solving geometric problems
/// with the rotating calipers", 1983. Test: "oriented boxes hold 100,000 shapes, and no angle of 1,000 gives a smaller
/// one"
OrientedBox orientedBoxOf(const Shape& shape, const Transform& pose = {});

/// Around points. Throws std::invalid_argument if there are none, or one is not finite.
OrientedBox orientedBoxOf(std::span<const Vec2> points);

/// Counter-clockwise, the one at -x, -y of its own axes first.
std::array<Vec2, 4> cornersOf(const OrientedBox& box);

/// Do they overlap or touch? Two convex outlines are apart just when one of the normals of their edges parts them: of
/// boxes there are four. Source: Gottschalk, Lin and Manocha, "OBBTree", SIGGRAPH 1996, in two dimensions.
/// Test: "oriented boxes overlap when the distance of their polygons says so"
bool overlap(const OrientedBox& a, const OrientedBox& b);
bool contains(const OrientedBox& box, const Vec2& point);

}  // namespace plumb
