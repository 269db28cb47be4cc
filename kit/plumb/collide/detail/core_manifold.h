// SPDX-License-Identifier: MIT
// Where do two circles or polygons touch, rounded or not, and which of their features make each contact point?
#pragma once
#include <cstddef>
#include <cstdint>

#include <plumb/collide/detail/core.h>
#include <plumb/collide/manifold_point.h>

namespace plumb {

/// A corner or an edge of one shape; up to 128 of each. Those of A and of B that made a contact point identify it in
/// the next step.
struct Feature {
    std::uint8_t code = 0;

    static Feature corner(std::size_t index) { return {static_cast<std::uint8_t>(index)}; }
    static Feature edge(std::size_t index) { return {static_cast<std::uint8_t>(0x80u | index)}; }
};

inline std::uint16_t featureOf(Feature a, Feature b) {
    return static_cast<std::uint16_t>(a.code << 8 | b.code);
}
inline std::uint16_t swapped(std::uint16_t feature) {
    return static_cast<std::uint16_t>(feature << 8 | feature >> 8);
}

struct CoreDisc {
    Vec2f center{0, 0};  ///< [m]
    float radius = 0;    ///< [m]
};

Manifold circleManifold(const CoreDisc& a, const CoreDisc& b, float margin);

/// A core of two or more points against a circle in its frame; magnitude: size of the coordinates before they were made
/// relative [m].
Manifold circleManifold(const Core& a, const CoreDisc& b, float magnitude, float margin);

/// A segment is a polygon of two edges. Two cores of two or more points each, in one frame; magnitude: size of b's
/// coordinates before they were made relative, for the rounding error [m].
Manifold polygonManifold(const Core& a, const Core& b, float magnitude, float margin);

/// The same with this edge of a as the reference edge; none if no part of b is above or below it.
Manifold edgeManifold(const Core& a, std::size_t edge, const Core& b, float magnitude, float margin);

}  // namespace plumb
