// SPDX-License-Identifier: MIT
#include <plumb/collide/detail/chain_manifold.h>

#include <algorithm>
#include <cmath>

#include <plumb/collide/detail/circle_manifold.h>
#include <plumb/collide/detail/polygon_manifold.h>
#include <plumb/collide/detail/rounding.h>

namespace plumb {

namespace {

/// Directions this near to a segment's own normal are its own: above what a body at rest trembles, and above the angle
/// within which faces count as facing [rad].
constexpr float own = 0.02f;
/// Joints that turn by less are flat [rad].
constexpr float flat = 1e-3f;
/// What is nearer than this at a joint, the neighbour has as well, as near: it holds it. What is farther may be on this
/// segment by the step's end. Must stay below the distance at which the world takes a contact for a touching one [m].
constexpr float touching = 0.005f;

/// This share of the height of its centre, and no more than this [m], a body may have sunk in what it stands on: the
/// world lets none go deeper into a wall in a step.
constexpr float sunkShare = 0.25f;
constexpr float deepest = 0.02f;

/// Past the neighbour's normal by less than this, a way is rather the neighbour's [sine of 45 degrees] ...
constexpr float steep = 0.707f;
/// ... if the segment's own is so many times as long: it may be that of a wall under a box that stands out over it.
constexpr float deeper = 2.5f;

/// The side of a segment on which the other shape is.
struct Side {
    std::size_t edge = 0;  ///< of the segment's two, back to back
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

/// One end of the segment, as a direction sees it that leans out over it.
struct Joint {
    std::size_t corner = 0;
    Vec2f outward;        ///< along the segment, out over this end
    Vec2f next{0, 0};     ///< the neighbour's normal, on the convex side; zero without a neighbour or where it is flat
    Vec2f normal{0, 0};   ///< the segment's own, on the convex side
    bool goesOn = false;  ///< there is a neighbour
    bool isOpen = false;  ///< it is a one-way top, in line
    bool isConvex = false;  ///< on one of the sides, that is: not flat
};

Joint jointAt(const Convex& piece, bool atEnd) {
    Joint joint;
    const Vec2f along = perp(piece.normals[0]);
    const Vec2f& neighbour = atEnd ? piece.after : piece.before;
    joint.corner = atEnd ? 1 : 0;
    joint.outward = atEnd ? along : Vec2f(-along);
    joint.isOpen = piece.oneSided && !isVector(neighbour);
    joint.goesOn = joint.isOpen || isVector(neighbour);
    const float turn = neighbour.dot(joint.outward);
    joint.isConvex = std::abs(turn) > flat;
    if (!joint.isConvex) return joint;
    joint.next = turn > 0 ? neighbour : Vec2f(-neighbour);
    joint.normal = turn > 0 ? piece.normals[0] : piece.normals[1];
    return joint;
}

/// How far a direction has turned past the neighbour's normal, away from the segment's own.
struct Past {
    float sine = 0, cosine = 1;

    bool isNear(float sineOfAngle) const { return cosine > 0 && std::abs(sine) < sineOfAngle; }
};

Past pastNext(const Joint& joint, const Vec2f& direction) {
    const float x = direction.dot(joint.outward), y = direction.dot(joint.normal);
    const float nextX = joint.next.dot(joint.outward), nextY = joint.next.dot(joint.normal);
    return {nextY * x - nextX * y, nextX * x + nextY * y};
}

float nearestOf(const Manifold& m) {
    return m.count == 2 ? std::min(m.points[0].separation, m.points[1].separation) : m.points[0].separation;
}

/// How far the other shape is outside of a line through a corner.
float gapAlong(const Vec2f& direction, const Vec2f& corner, const Core& other) {
    float lowest = direction.dot(other.vertex(0));
    for (std::size_t i = 1; i < other.count; ++i) lowest = std::min(lowest, direction.dot(other.vertex(i)));
    return lowest - direction.dot(corner) - other.radius;
}

/// The vertex of a core that lies lowest along a direction; of those that lie as low, the one nearest to a corner.
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

/// One point along another direction than the one found. Of what is rounded it lies straight below the core: from any
/// other place a disc that only rolls on would seem to come nearer.
Manifold turnedTo(const Vec2f& direction, float separation, const Vec2f& corner, const Core& other,
                  const Manifold& found) {
    Manifold result;
    result.normal = direction;
    result.count = 1;
    const Vec2f below = lowestVertex(direction, corner, other) - direction * (other.radius + 0.5f * separation);
    const Vec2f above = corner + direction * (0.5f * separation);
    result.points[0] = {other.radius > 0 ? below : above, separation, found.points[0].feature};
    return result;
}

/// Along the segment's own normal, as far as the other shape is above or below it.
Manifold ownManifold(const Core& segment, const Side& side, const Core& other, float far, float margin) {
    if (other.count > 1) return edgeManifold(segment, side.edge, other, far, margin);
    const Vec2f fromStart = other.vertex(0) - segment.vertex(side.edge);
    const Vec2f edge = segment.edgeFrom(side.edge);
    const float length = perp(side.normal).dot(edge), along = perp(side.normal).dot(fromStart);
    const float noise = roundingOf(far + manhattan(segment.vertex(0)) + manhattan(segment.vertex(1)));
    const float separation = side.normal.dot(fromStart) - other.radius;
    if (along < -noise || along > length + noise || !(separation <= margin)) return {};
    Manifold result;
    result.normal = side.normal;
    result.count = 1;
    result.points[0] = {other.vertex(0) - side.normal * (other.radius + 0.5f * separation), separation, 0};
    return result;
}

/// How far a point is outside of a shape's edges, negative inside, and of which one.
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

/// The neighbour, whose joint this is, finds the same way as this segment; unless it has a better one, through another
/// edge of the other shape, that is not allowed to it.
bool hasBetterWay(const Core& other, const Vec2f& corner, const Vec2f& way) {
    constexpr float opposite = -0.9999f;
    return other.normal(outsideOf(other, corner).edge).dot(way) > opposite;
}

/// Does the other shape lie over the neighbour, so that this has it along its own normal?
bool reachesOver(const Joint& joint, const Vec2f& corner, const Core& other) {
    const float turn = perp(joint.normal).dot(joint.outward);
    const Vec2f along = turn > 0 ? perp(joint.next) : Vec2f(-perp(joint.next));
    for (std::size_t i = 0; i < other.count; ++i) {
        const Vec2f fromCorner = other.vertex(i) - corner;
        if (along.dot(fromCorner) > touching) return true;
    }
    return false;
}

/// A segment, another shape, and the manifold that they would have if the segment were alone.
struct Encounter {
    Core segment, other;
    float far = 0, margin = 0;  ///< [m]
    Manifold found;
    float separation = 0;  ///< [m]
    bool apart = false;    ///< the two overlap by their radii, if at all
    Side side;
    Joint joint;           ///< the one over which the way found leans
    float lean = 0;        ///< its sine
    Past past;             ///< of the neighbour's normal
    bool between = false;  ///< the way found lies between the segment's normal and the neighbour's
};

Encounter meetingOf(const Convex& piece, const Core& other, float far, float margin) {
    Encounter m;
    m.segment = coreOf(piece);
    m.other = other;
    m.far = far;
    m.margin = margin;
    m.found = other.count > 1 ? polygonManifold(m.segment, other, far, margin)
                              : circleManifold(m.segment, CoreDisc{other.vertex(0), other.radius}, far, margin);
    if (m.found.count == 0) return m;
    const Vec2f& way = m.found.normal;
    m.separation = nearestOf(m.found);
    m.apart = m.separation + other.radius > 0;
    m.side = sideOf(m.segment, other);
    m.joint = jointAt(piece, way.dot(perp(m.segment.normal(0))) >= 0);
    m.lean = way.dot(m.joint.outward);
    if (!m.joint.isConvex) return m;
    m.past = pastNext(m.joint, way);
    m.between = m.past.sine <= 0;
    return m;
}

/// The way found is the segment's own, but for trembling, and its joint is no corner there; or it leads out on the far
/// side, so deep is the overlap.
Manifold alongOwn(const Encounter& m) {
    const bool below = m.apart && m.found.normal.dot(m.side.normal) < 0;
    const Side side = below ? Side{1 - m.side.edge, -m.side.normal, m.side.center} : m.side;
    const Manifold result = ownManifold(m.segment, side, m.other, m.far, m.margin);
    if (result.count > 0 || m.separation <= touching) return result;
    return turnedTo(side.normal, m.separation, m.segment.vertex(m.joint.corner), m.other, m.found);
}

/// The way found lies between both normals. The corner belongs to the segment that ends there, but for what lies along
/// the neighbour; and to the other where this one has another way.
Manifold aroundCorner(const Encounter& m) {
    const Vec2f corner = m.segment.vertex(m.joint.corner);
    const bool along = m.past.isNear(own / 2) && reachesOver(m.joint, corner, m.other);
    const bool ends = m.joint.corner == 1;
    const bool mine = ends ? !along : !m.apart && hasBetterWay(m.other, corner, m.found.normal);
    return m.lean <= own || mine || m.separation > touching ? m.found : Manifold{};
}

/// The way found is not allowed, and the two are apart.
Manifold turnedApart(const Encounter& m) {
    const Vec2f corner = m.segment.vertex(m.joint.corner);
    const bool convexHere = m.joint.isConvex && m.joint.normal.dot(m.side.normal) > 0;
    if (m.joint.isConvex && !convexHere) {
        // In a hollow the segment's plane bounds what the body may do, beyond its end too.
        const float gap = gapAlong(m.side.normal, corner, m.other);
        if (gap >= 0) return turnedTo(m.side.normal, gap, corner, m.other, m.found);
    }
    if (m.separation <= touching) return {};
    return turnedTo(convexHere ? m.joint.next : m.side.normal, m.separation, corner, m.other, m.found);
}

/// The way found is not allowed, and the two overlap.
Manifold turnedSunk(const Encounter& m) {
    const Manifold result = ownManifold(m.segment, m.side, m.other, m.far, m.margin);
    if (!m.joint.isConvex || !m.past.isNear(steep) || result.count == 0) return result;
    const float depth = -(m.separation + m.other.radius), ownDepth = -(nearestOf(result) + m.other.radius);
    return ownDepth > deeper * depth ? Manifold{} : result;
}

/// Of an outline that is solid on its left, in a hollow narrower than a quarter turn: all of that lies on this side of
/// its joint. What is met beyond it, or is as good as beyond it and beyond the neighbour, is met through the neighbour.
bool isThroughNeighbour(const Convex& piece, const Encounter& m) {
    const Vec2f outer = piece.normals[0];
    for (const bool atEnd : {false, true}) {
        const Joint joint = jointAt(piece, atEnd);
        const bool narrow = joint.isConvex && joint.normal.dot(outer) < 0 && joint.next.dot(outer) > 0;
        if (!narrow) continue;
        if (m.found.normal.dot(joint.outward) > own) return true;
        const Vec2f corner = m.segment.vertex(joint.corner), fromCorner = m.side.center - corner;
        if (joint.next.dot(fromCorner) > 0 && gapAlong(joint.outward, corner, m.other) > -touching) return true;
    }
    return false;
}

/// Is the other shape outside of a line through a corner, but for what it has sunk?
bool isAbove(const Vec2f& normal, const Vec2f& corner, const Encounter& m) {
    const float height = normal.dot(Vec2f(m.side.center - corner));
    const float sunk = std::max(touching, std::min(sunkShare * height, deepest));
    return gapAlong(normal, corner, m.other) >= -sunk;
}

/// Of a body on a segment's far side that stands over the neighbour at a convex joint. It cannot come to the segment
/// but through the neighbour, or around its far end, or around the corner, and then to the segment's near side: the far
/// side's plane would stop it at a brink that it goes over. It is the neighbour's where the corner is the segment's
/// nearest point, for then the neighbour is nearer; where it is outside of the neighbour, but for what it has sunk; and
/// where it stands around the corner, sunk, out over a cliff.
///
/// An outline, whose inside is solid, has such a neighbour in a one-way top alone: it is passed through from below, and
/// so only what stands on it is its own.
bool isNeighbours(const Joint& joint, const Encounter& m, bool oneSided) {
    if (!joint.isConvex || joint.normal.dot(m.side.normal) > 0) return false;
    const Vec2f corner = m.segment.vertex(joint.corner), fromCorner = m.side.center - corner;
    if (joint.next.dot(fromCorner) <= 0) return false;
    if (isAbove(joint.next, corner, m)) return true;
    if (oneSided) return false;
    if (m.apart && m.lean > own && joint.corner == m.joint.corner) return true;
    return m.separation <= touching && m.other.count > 1 && outsideOf(m.other, corner).distance < touching;
}

/// Of an outline that is solid on its left: is the other shape on its inner side, but for the way around a corner?
bool isBehind(const Convex& piece, const Encounter& m) {
    const Vec2f outer = piece.normals[0];
    if (m.side.normal.dot(outer) > 0) return isThroughNeighbour(piece, m);
    return !m.between || m.joint.normal.dot(outer) <= 0;
}

/// Where an outline goes on into a one-way top, in line: is the other shape beyond that end, and not on top? It is on
/// its way through, and the outline's edge below the corner meets it.
bool isThrough(const Joint& joint, const Encounter& m) {
    const Vec2f corner = m.segment.vertex(joint.corner);
    const bool beyond = joint.outward.dot(Vec2f(m.side.center - corner)) > 0;
    return joint.isOpen && beyond && !isAbove(m.side.normal, corner, m);
}

/// That edge has the corner as its own, from the side to the top: its joint is the hollow under the one-way top.
bool meetsCorner(const Encounter& m) {
    if (!m.joint.isConvex || m.joint.normal.dot(m.side.normal) > 0) return false;
    const bool leans = m.lean > (m.other.radius > 0 ? 0 : own);
    return leans && m.found.normal.dot(m.side.normal) >= 0 && m.found.normal.dot(m.joint.next) >= 0;
}

/// Does the contact belong to a neighbour of the segment, whatever way is found?
bool isElsewhere(const Convex& piece, const Encounter& m) {
    const bool around = m.between && m.lean > own;
    for (const bool atEnd : {false, true}) {
        const Joint joint = jointAt(piece, atEnd);
        if (isThrough(joint, m) || (!around && isNeighbours(joint, m, piece.oneSided))) return true;
    }
    return false;
}

}  // namespace

Manifold chainManifold(const Convex& piece, const Core& other, float far, float margin) {
    const Encounter m = meetingOf(piece, other, far, margin);
    if (m.found.count == 0) return m.found;
    if (piece.oneSided && isBehind(piece, m)) return {};
    if (isElsewhere(piece, m)) return {};
    if (piece.oneSided && meetsCorner(m)) return m.found;

    const bool allowed = m.joint.isConvex ? m.between : !m.joint.goesOn;
    const bool farSide = !m.apart && m.found.normal.dot(m.side.normal) < 0;
    if (m.lean <= own && (farSide || !allowed)) return alongOwn(m);
    if (!m.joint.goesOn) return m.found;
    if (m.between) return aroundCorner(m);
    return m.apart ? turnedApart(m) : turnedSunk(m);
}

}  // namespace plumb
