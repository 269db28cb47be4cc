// SPDX-License-Identifier: MIT
// Which of sixteen boxes may a ray hit, or a point be near, and at which fraction or distance?
#pragma once
#include <cstdint>

#include <plumb/broad/box_block.h>
#include <plumb/shapes/aabb.h>

namespace plumb {

/// A query for the nearest box, in float. A key is a lower bound: for a ray, of the fraction at which it enters a box;
/// for a point, of its distance from the box [m].
struct BoxProbe {
    float fromX = 0, fromY = 0;
    float inverseX = 0, inverseY = 0;  ///< of a ray: 1 / displacement along x and y [1/m]
    float marginX = 0, marginY = 0;    ///< boxes are enlarged by this: half size of the moving box, and rounding [m]

    using Keys = std::uint32_t (*)(const BoxProbe& probe, const BoxBlock& boxes, float limit, float* keys);
    Keys keys = nullptr;  ///< returns the lanes whose keys are at most limit, and the keys of all 16
};

/// A box of this half size that moves from one point to another; coordinates are relative to origin. lanes: as in
/// Space.
BoxProbe rayProbe(const Vec2& from, const Vec2& to, const Vec2& halfSize, const Vec2& origin, int lanes);
BoxProbe pointProbe(const Vec2& point, const Vec2& origin, int lanes);

/// A limit rounded up to float; infinity for numbers whose squares overflow in float.
float probeLimit(double limit);

/// A part of a ray, as fractions of its length.
struct RayPart {
    double first = 0, last = 1;
};
/// The part within a box, larger by a few roundings; first > last when there is none.
RayPart clipRay(const Vec2& from, const Vec2& to, const Aabb& box);

}  // namespace plumb
