// SPDX-License-Identifier: MIT
#include <plumb/collide/distance.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <plumb/collide/detail/outline.h>
#include <plumb/shapes/chain.h>

namespace plumb {

namespace {

/// The edge that the whole other shape is farthest outside of, and the other shape's corner nearest to its line.
struct FarAxis {
    std::size_t edge = 0, corner = 0;
    double separation = -std::numeric_limits<double>::infinity();
};

FarAxis bestAxis(const Outline& a, const Outline& b) {
    FarAxis best;
    for (std::size_t i = 0; i < a.edges; ++i) {
        FarAxis axis{i, 0, std::numeric_limits<double>::infinity()};
        for (std::size_t j = 0; j < b.count; ++j) {
            const double separation = a.normals[i].dot(b.corners[j] - a.corners[i]);
            if (separation < axis.separation) axis = {i, j, separation};
        }
        if (axis.separation > best.separation) best = axis;
    }
    return best;
}

/// The deepest corner of b below a's edge, and the point on the edge above it. If a face lies flush below the edge,
/// either of its corners may have been chosen, and it may extend past the edge: then the end of the edge is equally
/// deep.
Distance along(const FarAxis& axis, const Outline& a, const Outline& b) {
    const Vec2& normal = a.normals[axis.edge];
    const Vec2 edge = a.edgeFrom(axis.edge);
    const Vec2 fromStart = b.corners[axis.corner] - a.corners[axis.edge];
    const double part = fromStart.dot(edge) / std::max(edge.dot(edge), std::numeric_limits<double>::min());
    const Vec2 pointA = a.corners[axis.edge] + edge * std::clamp(part, 0.0, 1.0);
    return {axis.separation, normal, pointA, pointA + normal * axis.separation};
}

/// A corner of one shape and an edge of the other.
struct Nearest {
    double squared = std::numeric_limits<double>::infinity();  ///< of their distance [m^2]
    std::size_t edge = 0, corner = 0;
};

/// Corners of b against those edges of a that face the direction in which the two are separated.
Nearest nearestOf(const Outline& a, const Outline& b, const Vec2& apart) {
    Nearest best;
    for (std::size_t i = 0; i < a.edges; ++i) {
        if (a.normals[i].dot(apart) <= 0) continue;
        const Vec2 &start = a.corners[i], &end = a.corners[a.after(i)];
        const Vec2 edge = end - start;
        for (std::size_t j = 0; j < b.count; ++j) {
            const Vec2 fromStart = b.corners[j] - start;
            const double outside = a.normals[i].dot(fromStart);
            double squared = outside * outside;
            if (squared >= best.squared) continue;
            const Vec2 fromEnd = b.corners[j] - end;
            if (!(fromStart.dot(edge) > 0))
                squared = fromStart.squaredNorm();
            else if (!(fromEnd.dot(edge) < 0))
                squared = fromEnd.squaredNorm();
            if (squared < best.squared) best = {squared, i, j};
        }
    }
    return best;
}

/// From the edge's shape to the corner's.
Distance distanceOf(const Nearest& nearest, const Outline& a, const Outline& b) {
    const Vec2& start = a.corners[nearest.edge];
    const Vec2& end = a.corners[a.after(nearest.edge)];
    const Vec2& corner = b.corners[nearest.corner];
    const Vec2 edge = end - start, fromStart = corner - start, fromEnd = corner - end;
    const bool behindStart = fromStart.dot(edge) > 0;
    if (behindStart && fromEnd.dot(edge) < 0) {
        const Vec2& normal = a.normals[nearest.edge];
        const double separation = normal.dot(fromStart);
        return {separation, normal, corner - normal * separation, corner};
    }
    const Vec2& between = behindStart ? fromEnd : fromStart;
    const double separation = std::sqrt(between.dot(between));
    return {separation, between / separation, behindStart ? end : start, corner};
}

Distance exchanged(const Distance& d) {
    return {d.separation, -d.normal, d.pointB, d.pointA};
}

}  // namespace

Distance coreDistance(const Outline& a, const Outline& b) {
    if (a.edges == 0 && b.edges == 0) {
        const Vec2 between = b.corners[0] - a.corners[0];
        const double separation = std::sqrt(between.dot(between));
        const Vec2 normal = separation > 0 ? Vec2(between / separation) : Vec2(0, 1);
        return {separation, normal, a.corners[0], b.corners[0]};
    }
    const FarAxis onA = bestAxis(a, b);
    const FarAxis onB = bestAxis(b, a);
    const bool useB = onB.separation > onA.separation;
    const Distance axis = useB ? exchanged(along(onB, b, a)) : along(onA, a, b);
    if (!(axis.separation > 0)) return axis;

    const Nearest fromA = nearestOf(a, b, axis.normal);
    const Nearest fromB = nearestOf(b, a, -axis.normal);
    const bool nearerB = fromB.squared < fromA.squared;
    const Nearest& best = nearerB ? fromB : fromA;
    // So near that squares underflow, or so far that they overflow; or a position is NaN.
    if (!(best.squared > 0 && best.squared < std::numeric_limits<double>::infinity())) return axis;
    return nearerB ? exchanged(distanceOf(best, b, a)) : distanceOf(best, a, b);
}

Distance distance(const Outline& a, const Outline& b, const Vec2& origin) {
    Distance result = coreDistance(a, b);
    result.separation -= a.radius + b.radius;
    result.pointA += result.normal * a.radius + origin;
    result.pointB += origin - result.normal * b.radius;
    return result;
}

namespace {

Distance pieceDistance(const Shape& a, const Transform& poseA, const Shape& b, const Transform& poseB) {
    const Vec2& origin = poseA.position;
    return distance(outlineOf(a, poseA, origin), outlineOf(b, poseB, origin), origin);
}

}  // namespace

Distance distance(const Shape& a, const Transform& poseA, const Shape& b, const Transform& poseB) {
    if (!hasPieces(a) && !hasPieces(b)) return pieceDistance(a, poseA, b, poseB);
    const std::vector<Shape> piecesB = piecesOf(b);
    Distance nearest;
    nearest.separation = std::numeric_limits<double>::infinity();
    for (const Shape& pieceA : piecesOf(a)) {
        for (const Shape& pieceB : piecesB) {
            const Distance here = pieceDistance(pieceA, poseA, pieceB, poseB);
            if (here.separation < nearest.separation) nearest = here;
        }
    }
    return nearest;
}

}  // namespace plumb
