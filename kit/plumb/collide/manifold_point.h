// SPDX-License-Identifier: MIT
// What is a contact manifold?
#pragma once
#include <array>
#include <cstdint>

#include <plumb/collide/convex.h>
#include <plumb/math/vec2.h>

namespace plumb {

/// B's frame relative to A's: rotation, then translation.
struct RelativePose {
    Vec2f position{0, 0};  ///< [m]
    float cos = 1;
    float sin = 0;
};

struct ManifoldPoint {
    Vec2f position{0, 0};       ///< half way between the two surfaces, in A's frame [m]
    float separation = 0;       ///< along the normal, negative when they overlap [m]
    std::uint16_t feature = 0;  ///< id of the corners and edges that touch; stable from step to step [-]
};

struct Manifold {
    Vec2f normal{0, 1};  ///< unit, from A to B, in A's frame
    int count = 0;       ///< 0: farther apart than the margin
    std::array<ManifoldPoint, 2> points;
};

}  // namespace plumb
