// SPDX-License-Identifier: MIT
#include <plumb/collide/detail/core_manifold.h>

#include <cmath>

#include <plumb/collide/detail/core.h>

namespace plumb {

namespace {

/// A circle touches in one point only. The point keeps one feature id, and with it its impulse, when the circle rolls
/// from an edge over a corner.
constexpr std::uint16_t onlyPoint = 0;

/// The point at which disc B is nearest along normal. Written so that NaN gives no contact.
Manifold onePoint(const Vec2f& normal, float separation, const CoreDisc& b, float margin) {
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

/// The edge of a that the point is farthest outside of. NaN if the point is NaN.
Face farthestFace(const Core& a, const Vec2f& point) {
    Row outside;
    for (std::size_t i = 0; i < a.count; i += lanes) {
        const FourFloats dx = point.x() - lanesAt(a.x + i), dy = point.y() - lanesAt(a.y + i);
        store(lanesAt(a.normalX + i) * dx + lanesAt(a.normalY + i) * dy, outside.values + i);
    }
    const std::size_t edge = largestOf(outside, a.count);
    return {edge, outside.values[edge]};
}

}  // namespace

Manifold circleManifold(const CoreDisc& a, const CoreDisc& b, float margin) {
    constexpr float squaresUnderflow = 1e-18f;  // the centres coincide: any normal separates them
    const Vec2f between = b.center - a.center;
    const float distance = std::sqrt(between.dot(between));
    const Vec2f normal = distance > squaresUnderflow ? Vec2f(between / distance) : Vec2f(0, 1);
    return onePoint(normal, distance - a.radius - b.radius, b, margin);
}

Manifold circleManifold(const Core& a, const CoreDisc& b, float magnitude, float margin) {
    const Face face = farthestFace(a, b.center);
    const float radii = a.radius + b.radius;
    if (!(face.separation - radii <= margin)) return {};

    const Vec2f start = a.vertex(face.edge);
    const Vec2f end = a.vertex(a.after(face.edge));
    const Vec2f edge = end - start;
    const Vec2f fromStart = b.center - start;
    const Vec2f fromEnd = b.center - end;
    const bool beforeStart = fromStart.dot(edge) < 0;
    const bool behindEnd = fromEnd.dot(edge) > 0;

    // In line with a segment both its faces have separation 0: so not "separation > 0".
    const float noise = roundingOf(magnitude + manhattan(start) + manhattan(end));
    if ((beforeStart || behindEnd) && face.separation > -noise) {
        const Vec2f& fromCorner = beforeStart ? fromStart : fromEnd;
        const float distance = std::sqrt(fromCorner.dot(fromCorner));
        if (distance > noise) return onePoint(fromCorner / distance, distance - radii, b, margin);
    }
    return onePoint(a.normal(face.edge), face.separation - radii, b, margin);
}

}  // namespace plumb
