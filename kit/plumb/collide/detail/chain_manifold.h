// SPDX-License-Identifier: MIT
// Where does a segment whose line goes on beyond its ends touch, so that nothing catches on a joint?
#pragma once
#include <plumb/collide/detail/core.h>
#include <plumb/collide/manifold.h>

namespace plumb {

inline bool isVector(const Vec2f& v) {
    return v.x() != 0 || v.y() != 0;
}

/// Is this a segment with a neighbour?
inline bool goesOn(const Convex& shape) {
    return shape.count == 2 && (isVector(shape.before) || isVector(shape.after));
}

/// A segment with neighbours against any core in its frame, whose numbers came from as far as this [m].
///
/// Along the line a body may be pushed the ways the line's outline allows: a segment's own normal, to the side where
/// the body's centre is; at a joint that is convex on that side also the ways between both segments' normals; at an end
/// where the line does not go on, any way.
/// A joint's corner belongs to the segment that ends there: one contact, not two. A contact that would push another way
/// - as does the side of a box that lies flush on both, a little sunk - is
/// - along the own normal, cut to the stretch above the segment, where overlap is more than the neighbour's matter;
/// - none, where the neighbour has one that holds the body as well: on a flat or convex joint its plane does;
/// - turned to the nearest way allowed, while the body is not yet there: a fast one may be in this step.
/// Test: "a box, disc and capsule flush on chains, or a little sunk, are pushed the way the outline allows"
Manifold chainManifold(const Convex& piece, const Core& other, float far, float margin);

}  // namespace plumb
