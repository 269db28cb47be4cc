// SPDX-License-Identifier: MIT
// In which form do the manifold functions read a shape? Its core, with four corners or edges at a time. And which
// lengths are rounding errors there?
#pragma once
#include <cmath>
#include <cstddef>
#include <limits>

#include <Eigen/Core>

#include <plumb/collide/convex.h>
#include <plumb/math/vec2.h>

namespace plumb {

using FourFloats = Eigen::Array4f;
inline constexpr std::size_t lanes = 4;

inline FourFloats lanesAt(const float* from) {
    return Eigen::Map<const FourFloats>(from);
}
inline void store(const FourFloats& values, float* to) {
    Eigen::Map<FourFloats>{to} = values;
}

/// A view of a Convex, or of one that was transformed. Rows are filled up to a multiple of four with copies of the
/// last.
struct Core {
    const float* x = nullptr;  ///< of the vertices, counter-clockwise [m]
    const float* y = nullptr;
    const float* normalX = nullptr;  ///< outward, of the edge from each vertex to the next [-]
    const float* normalY = nullptr;
    std::size_t count = 0;
    float radius = 0;  ///< [m]

    Vec2f vertex(std::size_t i) const { return {x[i], y[i]}; }
    Vec2f normal(std::size_t i) const { return {normalX[i], normalY[i]}; }
    std::size_t after(std::size_t corner) const { return corner + 1 < count ? corner + 1 : 0; }
    Vec2f edgeFrom(std::size_t corner) const { return vertex(after(corner)) - vertex(corner); }
};

inline Core coreOf(const Convex& convex) {
    return {convex.vertices.x(),
            convex.vertices.y(),
            convex.normals.x(),
            convex.normals.y(),
            static_cast<std::size_t>(convex.count),
            convex.radius};
}

/// Memory for a core transformed to another frame. Not initialised: that would take longer than most manifolds.
struct PlacedRows {
    float x[maxPolygonVertices], y[maxPolygonVertices];
    float normalX[maxPolygonVertices], normalY[maxPolygonVertices];
};

/// One value for each corner or edge, four at a time.
struct Row {
    float values[maxPolygonVertices];
};

/// The index of the largest; the first of several. Without data-dependent branches.
inline std::size_t largestOf(const Row& row, std::size_t count) {
    std::size_t best = 0;
    float largest = row.values[0];
    for (std::size_t i = 1; i < count; ++i) {
        const bool larger = row.values[i] > largest;
        best = larger ? i : best;
        largest = larger ? row.values[i] : largest;
    }
    return best;
}

inline float manhattan(const Vec2f& v) {
    return std::abs(v.x()) + std::abs(v.y());
}

/// The rounding error of float arithmetic on coordinates of this size. Eight roundings of a number of this size:
/// rotation, translation, difference and product make about six.
inline float roundingOf(float size) {
    return 4 * std::numeric_limits<float>::epsilon() * size;
}

}  // namespace plumb
