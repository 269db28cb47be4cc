// SPDX-License-Identifier: MIT
#include <plumb/collide/detail/polygon_manifold.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <plumb/collide/detail/feature.h>
#include <plumb/collide/detail/rounding.h>

namespace plumb {

namespace {

/// How much better B's edge must be than A's parallel edge to be preferred, as a share of the shorter of the two: far
/// more than the jitter of a stack at rest (1e-6), far less than what is visible. Two points closer than this are one
/// point.
constexpr float edgePreference = 1e-4f;
/// The cosine of the angle within which two edges count as parallel, 0.8 degrees: far more than jitter, and too little
/// for the worse edge's normal to do harm. With a larger angle, rounded shapes got a direction that did not separate
/// them.
constexpr float parallelCosine = 0.9999f;

struct Axis {
    std::size_t edge = 0;
    float separation = 0;
};

/// The edge of a that b is farthest outside of. NaN if b's position is NaN.
Axis bestAxisOfFew(const Core& a, const Core& b) {
    Row separation;
    for (std::size_t i = 0; i < a.count; i += lanes) {
        const Lanes nx = lanesAt(a.normalX + i), ny = lanesAt(a.normalY + i);
        Lanes lowest = nx * b.x[0] + ny * b.y[0];
        for (std::size_t j = 1; j < b.count; ++j) lowest = lowest.min(nx * b.x[j] + ny * b.y[j]);
        store(lowest - (nx * lanesAt(a.x + i) + ny * lanesAt(a.y + i)), separation.values + i);
    }
    const std::size_t edge = largestOf(separation, a.count);
    return {edge, separation.values[edge]};
}

/// The same in one walk around both polygons: as a's normal rotates, b's lowest corner against it moves on around b.
/// Normals decide which corner that is, not heights: edges too short for their height to be significant do not stop the
/// walk.
Axis bestAxisOfMany(const Core& a, const Core& b) {
    std::size_t corner = 0;
    float lowest = a.normal(0).dot(b.vertex(0));
    for (std::size_t i = 1; i < b.count; ++i) {
        const float height = a.normal(0).dot(b.vertex(i));
        if (height < lowest) {
            lowest = height;
            corner = i;
        }
    }
    Axis best{0, lowest - a.normal(0).dot(a.vertex(0))};
    for (std::size_t i = 1; i < a.count; ++i) {
        for (std::size_t steps = 0; steps < b.count && cross(a.normal(i), b.normal(corner)) > 0; ++steps)
            corner = b.after(corner);
        const Vec2f fromStart = b.vertex(corner) - a.vertex(i);
        const float separation = a.normal(i).dot(fromStart);
        if (separation > best.separation) best = {i, separation};
    }
    return best;
}

/// Above this product of corner counts, the walk is faster.
constexpr std::size_t manyProducts = 256;

Axis bestAxis(const Core& a, const Core& b) {
    const bool many = a.count * b.count > manyProducts && a.count > 2 && b.count > 2;
    return many ? bestAxisOfMany(a, b) : bestAxisOfFew(a, b);
}

std::size_t edgeFacing(const Vec2f& normal, const Core& incident) {
    Row against;
    for (std::size_t i = 0; i < incident.count; i += lanes)
        store(-(normal.x() * lanesAt(incident.normalX + i) + normal.y() * lanesAt(incident.normalY + i)),
              against.values + i);
    return largestOf(against, incident.count);
}

/// A point of the incident edge in the coordinates of the reference edge.
struct EdgePoint {
    float along = 0;  ///< from the reference edge's start towards its end [m]
    float above = 0;  ///< out of the reference edge [m]
    Feature reference, incident;
};

/// The reference edge and the incident edge opposite to it.
struct Faces {
    std::size_t edge = 0, incidentEdge = 0;
    Feature start, end;             ///< corners of the reference edge
    Vec2f origin, normal, tangent;  ///< of the reference edge
    float length = 0;               ///< of the reference edge [m]
    EdgePoint low, high;            ///< ends of the incident edge; the two edges run in opposite directions
    float radius = 0;               ///< around the reference core [m]
    float incidentRadius = 0;       ///< [m]
    float rounding = 0;             ///< lengths below this are rounding errors [m]
    float slack = 0;                ///< lengths below this are insignificant [m]
};

Faces facesAt(const Core& reference, std::size_t edge, const Core& incident, float magnitude) {
    Faces f;
    f.edge = edge;
    f.start = Feature::corner(edge);
    f.end = Feature::corner(reference.after(edge));
    f.origin = reference.vertex(edge);
    f.normal = reference.normal(edge);
    f.tangent = perp(f.normal);
    const Vec2f whole = reference.edgeFrom(edge);
    f.length = f.tangent.dot(whole);

    f.incidentEdge = edgeFacing(f.normal, incident);
    const auto seen = [&](std::size_t corner) -> EdgePoint {
        const Vec2f fromOrigin = incident.vertex(corner) - f.origin;
        return {f.tangent.dot(fromOrigin), f.normal.dot(fromOrigin), Feature::edge(edge), Feature::corner(corner)};
    };
    f.high = seen(f.incidentEdge);
    f.low = seen(incident.after(f.incidentEdge));

    f.radius = reference.radius;
    f.incidentRadius = incident.radius;
    const Vec2f incidentWhole = incident.edgeFrom(f.incidentEdge);
    f.rounding = roundingOf(magnitude + manhattan(f.origin) + manhattan(whole) + manhattan(incidentWhole));
    f.slack = f.rounding + edgePreference * std::min(manhattan(whole), manhattan(incidentWhole));
    return f;
}

/// A corner of the incident edge and the corner of the reference edge nearest to it.
struct CornerPair {
    EdgePoint near, far;               ///< ends of the incident edge
    float gapAlong = 0, gapAbove = 0;  ///< from the reference corner to the near end [m]
    float squared() const { return gapAlong * gapAlong + gapAbove * gapAbove; }
};

CornerPair cornerPair(const EdgePoint& near, const EdgePoint& far, const Faces& f) {
    return {near, far, near.along - std::clamp(near.along, 0.0f, f.length), near.above};
}

/// The two corners that are nearest to each other, if they are separated and neither is nearest to the other's edge.
std::optional<CornerPair> facingCorners(const Faces& f) {
    const CornerPair low = cornerPair(f.low, f.high, f);
    const CornerPair high = cornerPair(f.high, f.low, f);
    const CornerPair& best = low.squared() < high.squared() ? low : high;
    if (best.gapAlong == 0 || best.squared() <= f.rounding * f.rounding) return std::nullopt;
    const float towardsFar = best.gapAlong * (best.far.along - best.near.along) +  //
                             best.gapAbove * (best.far.above - best.near.above);
    return towardsFar < 0 ? std::nullopt : std::optional(best);
}

Manifold cornerManifold(const CornerPair& pair, const Faces& f, float margin) {
    Manifold result;
    const float distance = std::sqrt(pair.squared());
    const float separation = distance - f.radius - f.incidentRadius;
    if (!(separation <= margin)) return result;
    const bool atStart = pair.gapAlong < 0;
    const Vec2f corner = atStart ? f.origin : Vec2f(f.origin + f.tangent * f.length);
    result.normal = f.tangent * (pair.gapAlong / distance) + f.normal * (pair.gapAbove / distance);
    result.count = 1;
    result.points[0] = {corner + result.normal * (f.radius + separation / 2), separation,
                        featureOf(atStart ? f.start : f.end, pair.near.incident)};
    return result;
}

/// Clips the end of the incident edge at a corner of the reference edge, if it extends beyond that corner by excess.
/// The point is then identified by that corner and the incident edge, as it would be with the roles exchanged. An
/// insignificant excess leaves the id as it is: a box that sits flush on an equal box and jitters keeps its impulses.
EdgePoint clipped(const EdgePoint& end, const EdgePoint& other, const Faces& f, float excess, Feature corner) {
    if (excess <= f.rounding) return end;
    const float width = other.along - end.along;
    const float part = std::min(excess / std::abs(width), 1.0f);
    EdgePoint cut{end.along + part * width, end.above + part * (other.above - end.above), end.reference, end.incident};
    if (excess <= f.slack) return cut;
    cut.reference = corner;
    cut.incident = Feature::edge(f.incidentEdge);
    return cut;
}

/// The ends of the stretch that both edges have in common.
Manifold faceManifold(const Faces& f, float margin) {
    Manifold result;
    result.normal = f.normal;
    const auto add = [&](const EdgePoint& point) {
        const float separation = point.above - f.radius - f.incidentRadius;
        if (!(separation <= margin)) return;
        const float above = point.above - f.incidentRadius - separation / 2;
        result.points[static_cast<std::size_t>(result.count++)] = {
            f.origin + f.tangent * point.along + f.normal * above, separation,
            featureOf(point.reference, point.incident)};
    };
    const bool upright = f.high.along - f.low.along <= f.slack;
    const EdgePoint low = upright ? f.low : clipped(f.low, f.high, f, -f.low.along, f.start);
    const EdgePoint high = upright ? f.high : clipped(f.high, f.low, f, f.high.along - f.length, f.end);
    if (high.along - low.along <= f.slack) {
        add(low.above < high.above ? low : high);
    } else {
        add(low);
        add(high);
    }
    return result;
}

/// separation is that of the best axis. For collinear segments no axis gives the gap between them: so not "> 0".
Manifold manifoldAt(const Faces& f, float separation, float margin) {
    const std::optional<CornerPair> corners = separation > -f.rounding ? facingCorners(f) : std::nullopt;
    return corners ? cornerManifold(*corners, f, margin) : faceManifold(f, margin);
}

/// The same manifold with the roles of A and B exchanged, in the same frame.
Manifold exchanged(Manifold m) {
    m.normal = -m.normal;
    for (ManifoldPoint& point : m.points) point.feature = swapped(point.feature);
    return m;
}

}  // namespace

Manifold edgeManifold(const Core& a, std::size_t edge, const Core& b, float magnitude, float margin) {
    const Faces f = facesAt(a, edge, b, magnitude);
    const bool beyond = std::min(f.low.along, f.high.along) > f.length + f.rounding ||
                        std::max(f.low.along, f.high.along) < -f.rounding;
    return beyond ? Manifold{} : faceManifold(f, margin);
}

Manifold polygonManifold(const Core& a, const Core& b, float magnitude, float margin) {
    const float reach = margin + a.radius + b.radius;
    const Axis onA = bestAxis(a, b);
    if (!(onA.separation <= reach)) return {};
    const Axis onB = bestAxis(b, a);
    if (!(onB.separation <= reach)) return {};

    const float best = std::max(onA.separation, onB.separation);
    if (onB.separation > onA.separation) {
        const Faces onEdgeB = facesAt(b, onB.edge, a, magnitude);
        const bool faces = a.normal(onA.edge).dot(onEdgeB.normal) < -parallelCosine;
        if (!faces || onB.separation > onA.separation + onEdgeB.slack)
            return exchanged(manifoldAt(onEdgeB, best, margin));
    }
    return manifoldAt(facesAt(a, onA.edge, b, magnitude), best, margin);
}

}  // namespace plumb
