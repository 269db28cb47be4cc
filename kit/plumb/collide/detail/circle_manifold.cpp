// SPDX-License-Identifier: MIT
#include <plumb/collide/detail/circle_manifold.h>

#include <cmath>

#include <plumb/collide/detail/rounding.h>

namespace plumb {

namespace {

/// A circle meets in one point, whatever it meets: it keeps one name, and so its impulse, when it rolls from an edge
/// over a corner.
constexpr std::uint16_t onlyPoint = 0;

/// The point at which disc B is nearest along normal. Written so that what is not a number makes no contact.
Manifold onePoint(const Vec2f& normal, float separation, const Disc& b, float margin) {
    Manifold result;
    if (!(separation <= margin)) return result;
    result.normal = normal;
    result.count = 1;
    result.points[0] = {b.center - normal * (b.radius + separation / 2), separation, onlyPoint};
    return result;
}

struct Face {
    std::size_t edge = 0;
    float separation = 0;
};

float separationFrom(const Convex& a, std::size_t edge, const Vec2f& point) {
    const Vec2f fromStart = point - a.vertices[edge];
    return a.normals[edge].dot(fromStart);
}

/// Of a's edges, the one that the point is farthest outside of. Not a number if the point is not.
Face farthestFace(const Convex& a, const Vec2f& point) {
    Face best{0, separationFrom(a, 0, point)};
    for (std::size_t i = 1; i < static_cast<std::size_t>(a.count); ++i) {
        const float separation = separationFrom(a, i, point);
        if (separation > best.separation) best = {i, separation};
    }
    return best;
}

}  // namespace

Manifold circleManifold(const Disc& a, const Disc& b, float margin) {
    constexpr float squaresUnderflow = 1e-18f;  // closer than this is one place: any normal parts them
    const Vec2f between = b.center - a.center;
    const float distance = std::sqrt(between.dot(between));
    const Vec2f normal = distance > squaresUnderflow ? Vec2f(between / distance) : Vec2f(0, 1);
    return onePoint(normal, distance - a.radius - b.radius, b, margin);
}

Manifold circleManifold(const Convex& a, const Disc& b, float far, float margin) {
    const Face face = farthestFace(a, b.center);
    const float radii = a.radius + b.radius;
    if (!(face.separation - radii <= margin)) return {};

    const std::size_t next = face.edge + 1 < static_cast<std::size_t>(a.count) ? face.edge + 1 : 0;
    const Vec2f& start = a.vertices[face.edge];
    const Vec2f& end = a.vertices[next];
    const Vec2f edge = end - start;
    const Vec2f fromStart = b.center - start;
    const Vec2f fromEnd = b.center - end;
    const bool beforeStart = fromStart.dot(edge) < 0;
    const bool behindEnd = fromEnd.dot(edge) > 0;

    // In line with a segment its two faces see nothing: so not "separation > 0".
    const float noise = roundingOf(far + manhattan(start) + manhattan(end));
    if ((beforeStart || behindEnd) && face.separation > -noise) {
        const Vec2f& fromCorner = beforeStart ? fromStart : fromEnd;
        const float distance = std::sqrt(fromCorner.dot(fromCorner));
        if (distance > noise) return onePoint(fromCorner / distance, distance - radii, b, margin);
    }
    return onePoint(a.normals[face.edge], face.separation - radii, b, margin);
}

}  // namespace plumb
