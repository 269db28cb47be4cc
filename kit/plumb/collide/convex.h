// SPDX-License-Identifier: MIT
// How do the hot loops see a shape? As a convex core of one or more points with a radius around it.
#pragma once
#include <array>
#include <span>
#include <vector>

#include <plumb/math/vec2f.h>
#include <plumb/shapes/shape.h>

namespace plumb {

/// Vectors as a row of x and a row of y, so that four of them go through a calculation at once: filled up to a multiple
/// of four with the last. Up to four need no memory of their own: there is a core for every shape of a world.
class FewVectors {
public:
    static constexpr std::size_t few = 4;

    FewVectors() = default;
    explicit FewVectors(std::span<const Vec2f> vectors);

    Vec2f operator[](std::size_t i) const { return {x()[i], y()[i]}; }
    const float* x() const { return many_.empty() ? few_.data() : many_.data(); }
    /// Of memory beside itself.
    std::size_t bytes() const { return many_.capacity() * sizeof(float); }
    const float* y() const { return many_.empty() ? few_.data() + few : many_.data() + many_.size() / 2; }

private:
    std::array<float, 2 * few> few_{};
    std::vector<float> many_;  ///< all of them, if they are more than a few
};

/// Circle: one point and its radius; capsule: two and its radius; segment: two points, radius 0; polygon: its corners
/// and its radius. Two points make a polygon of two edges, back to back.
/// Float, relative to a centre near the shape (the body's centre of mass): as precise anywhere in the world.
struct Convex {
    FewVectors vertices;  ///< counter-clockwise [m]
    FewVectors normals;   ///< outward, unit, of the edge from each vertex to the next [-]
    int count = 0;        ///< of vertices, and of normals
    float radius = 0;     ///< [m]
    /// Of a segment whose line goes on: the normals, on the side of normals[0], of the segments before and after it;
    /// zero where it ends.
    Vec2f before{0, 0}, after{0, 0};
    bool oneSided = false;  ///< solid on its left, met from its right alone; an end goes on into a one-way top
};

/// The shape as seen from center, a point of the body's frame. Throws std::invalid_argument on a Chain or TileMap (ask
/// for each of its pieces), and on a polygon of too few corners, or too many.
Convex convexOf(const Shape& shape, const Vec2& center);

}  // namespace plumb
