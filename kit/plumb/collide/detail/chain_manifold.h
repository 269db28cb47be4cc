// SPDX-License-Identifier: MIT
// Where does a segment whose line goes on beyond its ends touch, so that nothing catches on a joint?
#pragma once
#include <plumb/collide/detail/core.h>
#include <plumb/collide/manifold.h>
#include <plumb/math/vec2f.h>

namespace plumb {

inline bool isVector(const Vec2f& v) {
    return v.x() != 0 || v.y() != 0;
}

/// Is this a segment with a neighbour?
inline bool goesOn(const Convex& shape) {
    return shape.count == 2 && (isVector(shape.before) || isVector(shape.after) || shape.oneSided);
}

/// A segment with neighbours against any core in its frame, whose numbers came from as far as this [m].
///
/// Along the line a body may be pushed the ways that the line's outline allows: a segment's own normal; at a joint, on
/// the side where it is convex, also the ways between both segments' normals; at an end where the line does not go on,
/// any way. A corner belongs to the segment that ends there: one contact, not two. Where the nearest way is another, as
/// through the side of a box that lies flush on both segments, a little sunk, there is
/// - a contact along the own normal, to the side where the body's centre is, cut to the stretch above the segment; or
/// - none, where the neighbour has one that holds the body as well: on a flat or convex joint its plane does; or
/// - none, where the body stands over the neighbour, beyond a convex joint, and would meet the segment from its inside:
///   so does what slides towards a brink; or
/// - while the body is not yet there, one that is turned to the nearest way allowed: a fast one may be here in the
///   step. In a hollow its separation is that from the segment's plane, elsewhere that from the segment.
/// An outline that goes on into a one-way top is a floor in line to what stands on top, and a corner to what is on its
/// way through: the edge below, whose joint is the hollow under that top, meets that.
/// Test: "10,000 placements of each shape on bent chains are held, and pushed only the ways the outline allows"
Manifold chainManifold(const Convex& piece, const Core& other, float far, float margin);

}  // namespace plumb
