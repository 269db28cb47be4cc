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
    bool isConvex = false;  ///< on one of the sides, that is: not flat
};

Joint jointAt(const Convex& piece, bool atEnd) {
    Joint joint;
    const Vec2f along = perp(piece.normals[0]);
    const Vec2f& neighbour = atEnd ? piece.after : piece.before;
    joint.corner = atEnd ? 1 : 0;
    joint.outward = atEnd ? along : Vec2f(-along);
    joint.goesOn = isVector(neighbour);
    const float turn = neighbour.dot(joint.outward);
    joint.isConvex = joint.goesOn && std::abs(turn) > flat;
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

/// One point at a corner, along another direction than the one found.
Manifold turnedTo(const Vec2f& direction, float separation, const Vec2f& corner, const Manifold& found) {
    Manifold result;
    result.normal = direction;
    result.count = 1;
    result.points[0] = {corner + direction * (0.5f * separation), separation, found.points[0].feature};
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

/// Does a shape whose centre seems to be in the hollow of a joint stand around its corner from outside? So does a box
/// on a cliff, sunk a little, that stands out over its edge: it must not catch on the cliff's inside.
bool standsAround(const Joint& joint, const Core& segment, const Side& side, const Core& other) {
    if (!joint.isConvex || joint.normal.dot(side.normal) > 0) return false;
    const Vec2f corner = segment.vertex(joint.corner);
    const Vec2f fromCorner = side.center - corner;
    return joint.next.dot(fromCorner) > 0 && outsideOf(other, corner).distance < touching;
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

/// The two do not overlap, or only by their radii, and the way found is not allowed.
Manifold apartAt(const Joint& joint, const Core& segment, const Side& side, const Core& other, const Manifold& found) {
    const Vec2f corner = segment.vertex(joint.corner);
    const float separation = nearestOf(found);
    const bool convexHere = joint.isConvex && joint.normal.dot(side.normal) > 0;
    if (joint.isConvex && !convexHere) {
        // In a hollow the segment's plane bounds what the body may do, beyond its end too.
        const float gap = gapAlong(side.normal, corner, other);
        if (gap >= 0) return turnedTo(side.normal, gap, corner, found);
    }
    if (separation <= touching) return {};
    return turnedTo(convexHere ? joint.next : side.normal, separation, corner, found);
}

}  // namespace

Manifold chainManifold(const Convex& piece, const Core& other, float far, float margin) {
    const Core segment = coreOf(piece);
    const Manifold found = other.count > 1 ? polygonManifold(segment, other, far, margin)
                                           : circleManifold(segment, Disc{other.vertex(0), other.radius}, far, margin);
    if (found.count == 0) return found;
    const Vec2f& way = found.normal;
    const Joint joint = jointAt(piece, way.dot(perp(segment.normal(0))) >= 0);
    const float lean = way.dot(joint.outward);
    const float separation = nearestOf(found);
    const bool apart = separation + other.radius > 0;  // of the cores
    const Past past = joint.isConvex ? pastNext(joint, way) : Past{};
    const bool between = joint.isConvex && past.sine <= 0;

    const Side side = sideOf(segment, other);

    const bool around = separation <= touching && other.count > 1 &&
                        (standsAround(jointAt(piece, false), segment, side, other) ||
                         standsAround(jointAt(piece, true), segment, side, other));
    if (around && !between) return {};
    const bool wrongSide = !apart && way.dot(side.normal) < 0;
    const bool allowed = joint.isConvex ? between : !joint.goesOn;
    if (lean <= own && (wrongSide || !allowed)) {
        const bool below = apart && way.dot(side.normal) < 0;
        const Side facing = below ? Side{1 - side.edge, -side.normal, side.center} : side;
        const Manifold result = ownManifold(segment, facing, other, far, margin);
        if (result.count > 0 || separation <= touching) return result;
        return turnedTo(facing.normal, separation, segment.vertex(joint.corner), found);
    }
    if (!joint.goesOn) return found;
    const Vec2f corner = segment.vertex(joint.corner);
    if (between) {
        const bool mine =
            lean <= own || (joint.corner == 1 ? !(past.isNear(own / 2) && reachesOver(joint, corner, other))
                                              : !apart && hasBetterWay(other, corner, way));
        return mine || separation > touching ? found : Manifold{};
    }
    if (apart) return apartAt(joint, segment, side, other, found);
    const Manifold result = ownManifold(segment, side, other, far, margin);
    const bool neighbours = joint.isConvex && past.isNear(steep) && result.count > 0 &&
                            nearestOf(result) + other.radius < deeper * (separation + other.radius);
    return neighbours ? Manifold{} : result;
}

}  // namespace plumb
