// SPDX-License-Identifier: MIT
// How do the hot loops represent a shape? As a convex core of one or more points with a radius around it.
#pragma once
#include <array>
#include <span>
#include <vector>

#include <plumb/math/vec2.h>
#include <plumb/shapes/shape.h>

namespace plumb {

/// Vectors stored as a row of x and a row of y, so that four of them are computed at once; filled up to a multiple of
/// four with copies of the last. Up to four are stored in place, without heap memory: there is one such object for
/// every shape of a world.
class Vec2fArray {
public:
    static constexpr std::size_t inlineCapacity = 4;

    Vec2fArray() = default;
    explicit Vec2fArray(std::span<const Vec2f> vectors);

    Vec2f operator[](std::size_t i) const { return {x()[i], y()[i]}; }
    const float* x() const { return heap_.empty() ? inline_.data() : heap_.data(); }
    /// Heap memory in use.
    std::size_t bytes() const { return heap_.capacity() * sizeof(float); }
    const float* y() const { return heap_.empty() ? inline_.data() + inlineCapacity : heap_.data() + heap_.size() / 2; }

private:
    std::array<float, 2 * inlineCapacity> inline_{};
    std::vector<float> heap_;  ///< of all of them, if they do not fit in place
};

/// Circle: one point and its radius; capsule: two and its radius; segment: two points, radius 0; polygon: its corners
/// and its radius. Two points make a polygon of two edges, back to back.
/// Float, relative to a centre near the shape (the body's centre of mass), so that precision is the same anywhere in
/// the world.
struct Convex {
    Vec2fArray vertices;  ///< counter-clockwise [m]
    Vec2fArray normals;   ///< outward, unit, of the edge from each vertex to the next [-]
    int count = 0;        ///< of vertices, and of normals
    float radius = 0;     ///< [m]
    /// For a segment of a chain: the normals, on the side of normals[0], of the segments before and after it; zero
    /// where the chain ends.
    Vec2f before{0, 0}, after{0, 0};
    bool oneSided = false;  ///< solid on its left; may continue into a one-way top
};

/// The shape relative to center, a point of the body's frame. Throws std::invalid_argument on a Chain or TileMap
/// (convert each of its pieces), and on a polygon with too few or too many corners.
Convex convexOf(const Shape& shape, const Vec2& center);

/// Is this normal that of a neighbour, and not zero?
inline bool isVector(const Vec2f& v) {
    return v.x() != 0 || v.y() != 0;
}

/// Is this a segment with a neighbour?
inline bool isChainSegment(const Convex& shape) {
    return shape.count == 2 && (isVector(shape.before) || isVector(shape.after) || shape.oneSided);
}

}  // namespace plumb
