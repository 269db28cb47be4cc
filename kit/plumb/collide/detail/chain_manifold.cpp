// SPDX-License-Identifier: MIT
#include <plumb/collide/detail/chain_manifold.h>

#include <algorithm>
#include <cmath>

#include <plumb/collide/detail/core.h>
#include <plumb/collide/detail/core_manifold.h>

namespace plumb {

namespace {

/// Directions this near to a segment's own normal count as that normal: more than the jitter of a body at rest, and
/// more than the angle within which faces count as parallel [rad].
constexpr float ownAngle = 0.02f;
/// Chain vertices with a smaller turn are flat [rad].
constexpr float flatAngle = 1e-3f;
/// At a chain vertex, a shape nearer than this is as near to the neighbour, which has the contact. A shape farther away
/// may be on this segment by the end of the step. Must be below the distance at which the world counts a contact as
/// touching [m].
constexpr float touching = 0.005f;

/// A body may penetrate what it stands on by this share of the height of its centre, and no more than this [m]: the
/// world lets no body go deeper into a wall in a step.
constexpr float maxDepthShare = 0.25f;
constexpr float maxDepth = 0.02f;

/// A direction that has turned past the neighbour's normal by less than this belongs to the neighbour [sine of 45
/// degrees] ...
constexpr float steepSine = 0.707f;
/// ... if the depth along the segment's own normal is so many times as large: it may be the normal of a wall under a
/// box that projects over it.
constexpr float deeperFactor = 2.5f;

/// The side of a segment on which the other shape is.
struct Side {
    std::size_t edge = 0;  ///< of the segment's two edges, back to back
    Vec2f normal;
    Vec2f center;  ///< of the other shape
};

Side sideOf(const Core& segment, const Core& other) {
    Vec2f sum(0, 0);
    for (std::size_t i = 0; i < other.count; ++i) sum += other.vertex(i);
    const Vec2f center = sum / static_cast<float>(other.count);
    const Vec2f fromStart = center - segment.vertex(0);
    const std::size_t edge = segment.normal(0).dot(fromStart) >= 0 ? 0 : 1;
    return {edge, segment.normal(edge), center};
}

/// One end of the segment. The convex side is the one on which a contact direction leans outwards over this end.
struct EndVertex {
    std::size_t corner = 0;
    Vec2f outward;              ///< along the segment, outwards at this end
    Vec2f next{0, 0};           ///< the neighbour's normal on the convex side; zero if there is none, or it is flat
    Vec2f normal{0, 0};         ///< the segment's own, on the convex side
    bool hasNeighbour = false;  ///< there is a neighbour
    bool isOneWayTop = false;   ///< the neighbour is a one-way top in line with the segment
    bool isConvex = false;      ///< convex on one of the two sides, so not flat
};

EndVertex endVertexAt(const Convex& piece, bool atEnd) {
    EndVertex endVertex;
    const Vec2f along = perp(piece.normals[0]);
    const Vec2f& neighbour = atEnd ? piece.after : piece.before;
    endVertex.corner = atEnd ? 1 : 0;
    endVertex.outward = atEnd ? along : Vec2f(-along);
    endVertex.isOneWayTop = piece.oneSided && !isVector(neighbour);
    endVertex.hasNeighbour = endVertex.isOneWayTop || isVector(neighbour);
    const float turn = neighbour.dot(endVertex.outward);
    endVertex.isConvex = std::abs(turn) > flatAngle;
    if (!endVertex.isConvex) return endVertex;
    endVertex.next = turn > 0 ? neighbour : Vec2f(-neighbour);
    endVertex.normal = turn > 0 ? piece.normals[0] : piece.normals[1];
    return endVertex;
}

/// How far a direction is rotated past the neighbour's normal, away from the segment's own.
struct TurnPast {
    float sine = 0, cosine = 1;

    bool isNear(float sineOfAngle) const { return cosine > 0 && std::abs(sine) < sineOfAngle; }
};

TurnPast turnPastNeighbour(const EndVertex& endVertex, const Vec2f& direction) {
    const float x = direction.dot(endVertex.outward), y = direction.dot(endVertex.normal);
    const float nextX = endVertex.next.dot(endVertex.outward), nextY = endVertex.next.dot(endVertex.normal);
    return {nextY * x - nextX * y, nextX * x + nextY * y};
}

float nearestOf(const Manifold& m) {
    return m.count == 2 ? std::min(m.points[0].separation, m.points[1].separation) : m.points[0].separation;
}

/// How far the other shape is outside of the line through a corner with this normal.
float gapAlong(const Vec2f& direction, const Vec2f& corner, const Core& other) {
    float lowest = direction.dot(other.vertex(0));
    for (std::size_t i = 1; i < other.count; ++i) lowest = std::min(lowest, direction.dot(other.vertex(i)));
    return lowest - direction.dot(corner) - other.radius;
}

/// The vertex of a core that is lowest along a direction; of several that are equally low, the one nearest to a corner.
Vec2f lowestVertex(const Vec2f& direction, const Vec2f& corner, const Core& core) {
    Vec2f best = core.vertex(0);
    for (std::size_t i = 1; i < core.count; ++i) {
        const Vec2f vertex = core.vertex(i);
        const float lower = direction.dot(Vec2f(best - vertex));
        const float noise = roundingOf(manhattan(best) + manhattan(vertex));
        const bool nearer = (vertex - corner).squaredNorm() < (best - corner).squaredNorm();
        if (lower > noise || (lower >= -noise && nearer)) best = vertex;
    }
    return best;
}

/// One contact point along a direction other than the one found. For a rounded shape it lies straight below the core:
/// at any other place a disc that only rolls would seem to approach.
Manifold redirected(const Vec2f& direction, float separation, const Vec2f& corner, const Core& other,
                    const Manifold& found) {
    Manifold result;
    result.normal = direction;
    result.count = 1;
    const Vec2f below = lowestVertex(direction, corner, other) - direction * (other.radius + 0.5f * separation);
    const Vec2f above = corner + direction * (0.5f * separation);
    result.points[0] = {other.radius > 0 ? below : above, separation, found.points[0].feature};
    return result;
}

/// The manifold along the segment's own normal, for the part of the other shape above or below the segment.
Manifold ownManifold(const Core& segment, const Side& side, const Core& other, float magnitude, float margin) {
    if (other.count > 1) return edgeManifold(segment, side.edge, other, magnitude, margin);
    const Vec2f fromStart = other.vertex(0) - segment.vertex(side.edge);
    const Vec2f edge = segment.edgeFrom(side.edge);
    const float length = perp(side.normal).dot(edge), along = perp(side.normal).dot(fromStart);
    const float noise = roundingOf(magnitude + manhattan(segment.vertex(0)) + manhattan(segment.vertex(1)));
    const float separation = side.normal.dot(fromStart) - other.radius;
    if (along < -noise || along > length + noise || !(separation <= margin)) return {};
    Manifold result;
    result.normal = side.normal;
    result.count = 1;
    result.points[0] = {other.vertex(0) - side.normal * (other.radius + 0.5f * separation), separation, 0};
    return result;
}

/// How far a point is outside of a shape's edges, negative inside, and for which edge that is.
struct Outside {
    std::size_t edge = 0;
    float distance = 0;
};

Outside outsideOf(const Core& shape, const Vec2f& point) {
    Outside best;
    for (std::size_t i = 0; i < shape.count; ++i) {
        const Vec2f fromEdge = point - shape.vertex(i);
        const float distance = shape.normal(i).dot(fromEdge);
        if (i == 0 || distance > best.distance) best = {i, distance};
    }
    return best;
}

/// The neighbour at this vertex finds the same direction as this segment, unless it finds a shallower one, through
/// another edge of the other shape, that the neighbour may not use.
bool hasShallowerDirection(const Core& other, const Vec2f& corner, const Vec2f& direction) {
    constexpr float opposite = -0.9999f;
    return other.normal(outsideOf(other, corner).edge).dot(direction) > opposite;
}

/// Does the other shape lie over the neighbour, so that the neighbour has a contact along its own normal?
bool extendsOver(const EndVertex& endVertex, const Vec2f& corner, const Core& other) {
    const float turn = perp(endVertex.normal).dot(endVertex.outward);
    const Vec2f along = turn > 0 ? perp(endVertex.next) : Vec2f(-perp(endVertex.next));
    for (std::size_t i = 0; i < other.count; ++i) {
        const Vec2f fromCorner = other.vertex(i) - corner;
        if (along.dot(fromCorner) > touching) return true;
    }
    return false;
}

/// A segment, another shape, and the manifold that they would have if the segment had no neighbours.
struct SegmentContact {
    Core segment, other;
    float magnitude = 0, margin = 0;  ///< [m]
    Manifold found;
    float separation = 0;    ///< [m]
    bool separated = false;  ///< the cores do not overlap: at most the radii do
    Side side;
    EndVertex endVertex;   ///< the end over which the direction found leans
    float lean = 0;        ///< sine of the angle by which it leans
    TurnPast turnPast;     ///< rotation past the neighbour's normal
    bool between = false;  ///< the direction found lies between the segment's normal and the neighbour's
};

SegmentContact segmentContactOf(const Convex& piece, const Core& other, float magnitude, float margin) {
    SegmentContact m;
    m.segment = coreOf(piece);
    m.other = other;
    m.magnitude = magnitude;
    m.margin = margin;
    m.found = other.count > 1 ? polygonManifold(m.segment, other, magnitude, margin)
                              : circleManifold(m.segment, CoreDisc{other.vertex(0), other.radius}, magnitude, margin);
    if (m.found.count == 0) return m;
    const Vec2f& direction = m.found.normal;
    m.separation = nearestOf(m.found);
    m.separated = m.separation + other.radius > 0;
    m.side = sideOf(m.segment, other);
    m.endVertex = endVertexAt(piece, direction.dot(perp(m.segment.normal(0))) >= 0);
    m.lean = direction.dot(m.endVertex.outward);
    if (!m.endVertex.isConvex) return m;
    m.turnPast = turnPastNeighbour(m.endVertex, direction);
    m.between = m.turnPast.sine <= 0;
    return m;
}

/// The direction found is the segment's own normal, up to jitter, and the vertex is flat there; or it points to the far
/// side, because the overlap is deep.
Manifold alongOwnNormal(const SegmentContact& m) {
    const bool below = m.separated && m.found.normal.dot(m.side.normal) < 0;
    const Side side = below ? Side{1 - m.side.edge, -m.side.normal, m.side.center} : m.side;
    const Manifold result = ownManifold(m.segment, side, m.other, m.magnitude, m.margin);
    if (result.count > 0 || m.separation <= touching) return result;
    return redirected(side.normal, m.separation, m.segment.vertex(m.endVertex.corner), m.other, m.found);
}

/// The direction found lies between both normals. A corner belongs to the segment that ends there, except for a shape
/// that lies along the neighbour; and to the other segment where this one has a shallower direction.
Manifold aroundCorner(const SegmentContact& m) {
    const Vec2f corner = m.segment.vertex(m.endVertex.corner);
    const bool along = m.turnPast.isNear(ownAngle / 2) && extendsOver(m.endVertex, corner, m.other);
    const bool ends = m.endVertex.corner == 1;
    const bool mine = ends ? !along : !m.separated && hasShallowerDirection(m.other, corner, m.found.normal);
    return m.lean <= ownAngle || mine || m.separation > touching ? m.found : Manifold{};
}

/// The direction found is not allowed, and the cores are separated.
Manifold redirectedSeparated(const SegmentContact& m) {
    const Vec2f corner = m.segment.vertex(m.endVertex.corner);
    const bool convexHere = m.endVertex.isConvex && m.endVertex.normal.dot(m.side.normal) > 0;
    if (m.endVertex.isConvex && !convexHere) {
        // In a concave corner the plane of the segment limits the body beyond the segment's end too.
        const float gap = gapAlong(m.side.normal, corner, m.other);
        if (gap >= 0) return redirected(m.side.normal, gap, corner, m.other, m.found);
    }
    if (m.separation <= touching) {
        // The neighbour has the nearest point. What lies above this segment may turn down onto it within the step.
        if (m.endVertex.isConvex || m.other.count == 1) return {};
        return ownManifold(m.segment, m.side, m.other, m.magnitude, m.margin);
    }
    return redirected(convexHere ? m.endVertex.next : m.side.normal, m.separation, corner, m.other, m.found);
}

/// The direction found is not allowed, and the cores overlap.
Manifold redirectedOverlapping(const SegmentContact& m) {
    const Manifold result = ownManifold(m.segment, m.side, m.other, m.magnitude, m.margin);
    if (!m.endVertex.isConvex || !m.turnPast.isNear(steepSine) || result.count == 0) return result;
    const float depth = -(m.separation + m.other.radius), ownDepth = -(nearestOf(result) + m.other.radius);
    return ownDepth > deeperFactor * depth ? Manifold{} : result;
}

/// For an outline that is solid on its left, with a concave corner of less than 90 degrees: the whole corner lies on
/// this side of the vertex. A shape beyond the vertex, or almost beyond it and beyond the neighbour, has its contact
/// with the neighbour.
bool hitsThroughNeighbour(const Convex& piece, const SegmentContact& m) {
    const Vec2f outer = piece.normals[0];
    for (const bool atEnd : {false, true}) {
        const EndVertex endVertex = endVertexAt(piece, atEnd);
        const bool narrow = endVertex.isConvex && endVertex.normal.dot(outer) < 0 && endVertex.next.dot(outer) > 0;
        if (!narrow) continue;
        if (m.found.normal.dot(endVertex.outward) > ownAngle) return true;
        const Vec2f corner = m.segment.vertex(endVertex.corner), fromCorner = m.side.center - corner;
        if (endVertex.next.dot(fromCorner) > 0 && gapAlong(endVertex.outward, corner, m.other) > -touching) return true;
    }
    return false;
}

/// Is the other shape outside of the line through a corner with this normal, up to the allowed penetration?
bool isAbove(const Vec2f& normal, const Vec2f& corner, const SegmentContact& m) {
    const float height = normal.dot(Vec2f(m.side.center - corner));
    const float allowedDepth = std::max(touching, std::min(maxDepthShare * height, maxDepth));
    return gapAlong(normal, corner, m.other) >= -allowedDepth;
}

/// For a body on the far side of a segment that stands over the neighbour at a convex vertex. It can reach the segment
/// only through the neighbour, around the neighbour's far end, or around the corner, and then it comes to the near
/// side. A contact with the far side's plane would stop it at an edge that it slides over. The contact belongs to the
/// neighbour where the corner is the segment's nearest point, because then the neighbour is nearer; where the body is
/// outside of the neighbour, up to the allowed penetration; and where it stands around the corner and penetrates, over
/// a cliff.
///
/// An outline, whose inside is solid, has such a neighbour only if that is a one-way top. Bodies pass a one-way top
/// from below, so only a body that stands on it belongs to it.
bool belongsToNeighbour(const EndVertex& endVertex, const SegmentContact& m, bool oneSided) {
    if (!endVertex.isConvex || endVertex.normal.dot(m.side.normal) > 0) return false;
    const Vec2f corner = m.segment.vertex(endVertex.corner), fromCorner = m.side.center - corner;
    if (endVertex.next.dot(fromCorner) <= 0) return false;
    if (isAbove(endVertex.next, corner, m)) return true;
    if (oneSided) return false;
    if (m.separated && m.lean > ownAngle && endVertex.corner == m.endVertex.corner) return true;
    return m.separation <= touching && m.other.count > 1 && outsideOf(m.other, corner).distance < touching;
}

/// For an outline that is solid on its left: is the other shape on its inner side, unless it is coming around a corner?
bool isBehind(const Convex& piece, const SegmentContact& m) {
    const Vec2f outer = piece.normals[0];
    if (m.side.normal.dot(outer) > 0) return hitsThroughNeighbour(piece, m);
    return !m.between || m.endVertex.normal.dot(outer) <= 0;
}

/// At an end that continues into a one-way top in line: is the other shape beyond that end and not on top? Then it is
/// passing through, and its contact is with the outline's edge below the corner.
bool passesThrough(const EndVertex& endVertex, const SegmentContact& m) {
    const Vec2f corner = m.segment.vertex(endVertex.corner);
    const bool beyond = endVertex.outward.dot(Vec2f(m.side.center - corner)) > 0;
    return endVertex.isOneWayTop && beyond && !isAbove(m.side.normal, corner, m);
}

/// The edge below such a corner owns the corner's directions, from the side to the top: its own vertex there is the
/// concave corner under the one-way top.
bool meetsCorner(const SegmentContact& m) {
    if (!m.endVertex.isConvex || m.endVertex.normal.dot(m.side.normal) > 0) return false;
    const bool leans = m.lean > (m.other.radius > 0 ? 0 : ownAngle);
    return leans && m.found.normal.dot(m.side.normal) >= 0 && m.found.normal.dot(m.endVertex.next) >= 0;
}

/// Does the contact belong to a neighbour of the segment, whatever direction is found?
bool belongsElsewhere(const Convex& piece, const SegmentContact& m) {
    const bool around = m.between && m.lean > ownAngle;
    for (const bool atEnd : {false, true}) {
        const EndVertex endVertex = endVertexAt(piece, atEnd);
        if (passesThrough(endVertex, m) || (!around && belongsToNeighbour(endVertex, m, piece.oneSided))) return true;
    }
    return false;
}

}  // namespace

Manifold chainManifold(const Convex& piece, const Core& other, float magnitude, float margin) {
    const SegmentContact m = segmentContactOf(piece, other, magnitude, margin);
    if (m.found.count == 0) return m.found;
    if (piece.oneSided && isBehind(piece, m)) return {};
    if (belongsElsewhere(piece, m)) return {};
    if (piece.oneSided && meetsCorner(m)) return m.found;

    const bool allowed = m.endVertex.isConvex ? m.between : !m.endVertex.hasNeighbour;
    const bool farSide = !m.separated && m.found.normal.dot(m.side.normal) < 0;
    if (m.lean <= ownAngle && (farSide || !allowed)) return alongOwnNormal(m);
    if (!m.endVertex.hasNeighbour) return m.found;
    if (m.between) return aroundCorner(m);
    return m.separated ? redirectedSeparated(m) : redirectedOverlapping(m);
}

}  // namespace plumb
