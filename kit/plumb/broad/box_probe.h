// SPDX-License-Identifier: MIT
// Which of sixteen boxes may a ray meet, or a point be near, and how soon?
#pragma once
#include <cstdint>

#include <plumb/broad/box_block.h>
#include <plumb/shapes/aabb.h>

namespace plumb {

/// A look for what is nearest, in float. A key is a bound from below: for a ray, of the fraction of its way at which it
/// enters a box; for a point, of its distance from the box [m].
struct BoxProbe {
    float fromX = 0, fromY = 0;
    float perX = 0, perY = 0;    ///< of a ray: fraction by length along x and y [1/m]
    float growX = 0, growY = 0;  ///< boxes are larger by this: what moves along the ray, and roundings [m]

    using Keys = std::uint32_t (*)(const BoxProbe& probe, const BoxBlock& boxes, float limit, float* keys);
    Keys keys = nullptr;  ///< the lanes whose keys are limit or less, and the keys of all 16
};

/// A box of this half size that goes from one point to another; all is seen from origin. lanes: as Space has them.
BoxProbe rayProbe(const Vec2& from, const Vec2& to, const Vec2& halfSize, const Vec2& origin, int lanes);
BoxProbe pointProbe(const Vec2& point, const Vec2& origin, int lanes);

/// A limit as a float that is no smaller, and infinity for what floats can not square.
float probeLimit(double limit);

/// A part of a ray, by fractions of its way.
struct RayPart {
    double first = 0, last = 1;
};
/// The part within a box, a few roundings more than less; first > last when there is none.
RayPart clipRay(const Vec2& from, const Vec2& to, const Aabb& box);

}  // namespace plumb
