// SPDX-License-Identifier: MIT
// Where does a segment of a chain touch, so that bodies slide over its vertices without catching?
#pragma once
#include <plumb/collide/convex.h>
#include <plumb/collide/detail/core.h>
#include <plumb/collide/manifold_point.h>
#include <plumb/math/vec2.h>

namespace plumb {

/// A segment with neighbours against any core in its frame; magnitude: size of the coordinates before they were made
/// relative, for the rounding error [m].
///
/// A chain may push a body only in the directions that its outline allows: a segment's own normal; at a vertex, on the
/// convex side, also the directions between the normals of both segments; at a free end, any direction. A corner
/// belongs to the segment that ends there: one contact, not two. Where the nearest direction is another one, such as
/// through the side of a box that lies flush on both segments and penetrates a little, the result is
/// - a contact along the segment's own normal, on the side where the body's centre is, clipped to the region above the
///   segment; or
/// - none, where the neighbour has a contact that holds the body as well: its plane does so at a flat or convex vertex;
///   or
/// - none, where the body stands over the neighbour, beyond a convex vertex, and would collide with the segment from
///   the inside: this happens when a body slides towards an edge; or
/// - while the body is not yet there, a contact with the normal turned to the nearest allowed direction: a fast body
///   may arrive within the step. In a concave corner its separation is that from the segment's plane, elsewhere that
///   from the segment.
/// An outline that continues into a one-way top is a flat floor for a body that stands on top, and a corner for a body
/// that is passing through. That body has its contact with the edge below, whose vertex is the concave corner under the
/// top.
/// Test: "10,000 placements of each shape on bent chains are held, and pushed only the ways the outline allows"
Manifold chainManifold(const Convex& piece, const Core& other, float magnitude, float margin);

}  // namespace plumb
