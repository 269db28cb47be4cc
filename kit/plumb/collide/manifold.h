// SPDX-License-Identifier: MIT
// Where do two shapes touch, or come so near that they may touch in this step?
#pragma once
#include <array>
#include <cstdint>

#include <plumb/collide/convex.h>
#include <plumb/math/vec2f.h>

namespace plumb {

/// B's frame seen from A's: rotation, then shift.
struct RelativePose {
    Vec2f position{0, 0};  ///< [m]
    float cos = 1;
    float sin = 0;
};

struct ManifoldPoint {
    Vec2f position{0, 0};       ///< half way between the two surfaces, in A's frame [m]
    float separation = 0;       ///< along the normal, negative when they overlap [m]
    std::uint16_t feature = 0;  ///< which corner met which edge or corner: the same while they do, but for flickers [-]
};

struct Manifold {
    Vec2f normal{0, 1};  ///< unit, from A to B, in A's frame
    int count = 0;       ///< 0: farther apart than the margin
    std::array<ManifoldPoint, 2> points;
};

/// The contact manifold of two convex cores with radii; empty when they are farther apart than margin [m].
/// Two edges that face each other meet in up to two points: the ends of the stretch they share. Apart, corner to
/// corner, the normal is the line between the corners, and there is one point. Overlapping, the normal is the way that
/// parts them soonest. Of two edges that face each other and do equally well, to 1e-4 of the shorter one, A's lends its
/// normal, so that a box at rest on its like does not swap faces from step to step.
/// Apart from that, separations and positions are right to about 1e-6 of the sizes and distances that come in.
/// Contacts of a segment whose line goes on push only the ways that the line's outline allows.
/// Source: separating axes and clipping of the facing edge; Gregorius, "Robust Contact Creation for Physics
/// Simulations", GDC 2015.
/// Test: "manifolds of 10,000 placements of each pair of shapes agree with the Minkowski difference"
Manifold manifold(const Convex& a, const Convex& b, const RelativePose& bInA, float margin);

}  // namespace plumb
