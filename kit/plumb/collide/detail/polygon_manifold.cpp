// SPDX-License-Identifier: MIT

#include <algorithm>
#include <cstdint>

#include <plumb/collide/detail/core.h>
#include <plumb/collide/detail/core_manifold.h>
#include <plumb/collide/detail/facing_edges.h>

namespace plumb {

namespace {

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
        const FourFloats nx = lanesAt(a.normalX + i), ny = lanesAt(a.normalY + i);
        FourFloats lowest = nx * b.x[0] + ny * b.y[0];
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

using Edges = FacingEdges<1>;

Edges edgesAt(const Core& reference, std::size_t edge, const Core& incident, float magnitude) {
    const std::size_t end = reference.after(edge), facing = edgeFacing(reference.normal(edge), incident);
    const std::size_t low = incident.after(facing);
    const Vec2f whole = reference.edgeFrom(edge), incidentWhole = incident.edgeFrom(facing);
    Edges f;
    f.startX = reference.x[edge];
    f.startY = reference.y[edge];
    f.alongX = whole.x();
    f.alongY = whole.y();
    f.normalX = reference.normalX[edge];
    f.normalY = reference.normalY[edge];
    f.highX = incident.x[facing];
    f.highY = incident.y[facing];
    f.lowX = incident.x[low];
    f.lowY = incident.y[low];
    f.edge = f.start = static_cast<std::int32_t>(edge);
    f.end = static_cast<std::int32_t>(end);
    f.incidentEdge = f.high = static_cast<std::int32_t>(facing);
    f.low = static_cast<std::int32_t>(low);
    f.radius = reference.radius;
    f.incidentRadius = incident.radius;
    const float coordinates = manhattan(reference.vertex(edge)) + manhattan(whole) + manhattan(incidentWhole);
    f.rounding = roundingOf(magnitude + coordinates);
    f.slack = f.rounding + edgePreference * std::min(manhattan(whole), manhattan(incidentWhole));
    return f;
}

Manifold manifoldOf(const TouchingEdges<1>& touch) {
    Manifold result;
    result.normal = {touch.normalX, touch.normalY};
    result.count = touch.count;
    for (std::size_t p = 0; p < 2; ++p) {
        const TouchingEdges<1>::Point& point = touch.points[p];
        const auto code = [](std::int32_t feature) { return Feature{static_cast<std::uint8_t>(feature)}; };
        result.points[p] = {
            {point.x, point.y}, point.separation, featureOf(code(point.reference), code(point.incident))};
    }
    return result;
}

/// separation is that of the best axis. For collinear segments no axis gives the gap between them: so not "> 0".
Manifold manifoldAt(const Edges& f, float separation, float margin) {
    return manifoldOf(f.meet(separation > -f.rounding, margin));
}

/// The same manifold with the roles of A and B exchanged, in the same frame.
Manifold exchanged(Manifold m) {
    m.normal = -m.normal;
    for (ManifoldPoint& point : m.points) point.feature = swapped(point.feature);
    return m;
}

}  // namespace

Manifold edgeManifold(const Core& a, std::size_t edge, const Core& b, float magnitude, float margin) {
    const Edges f = edgesAt(a, edge, b, magnitude);
    const float length = a.edgeFrom(edge).dot(perp(a.normal(edge)));
    const float low = f.seen(f.lowX, f.lowY, f.low).along, high = f.seen(f.highX, f.highY, f.high).along;
    const bool beyond = std::min(low, high) > length + f.rounding || std::max(low, high) < -f.rounding;
    return beyond ? Manifold{} : manifoldOf(f.meet(false, margin));
}

Manifold polygonManifold(const Core& a, const Core& b, float magnitude, float margin) {
    const float reach = margin + a.radius + b.radius;
    const Axis onA = bestAxis(a, b);
    if (!(onA.separation <= reach)) return {};
    const Axis onB = bestAxis(b, a);
    if (!(onB.separation <= reach)) return {};

    const float best = std::max(onA.separation, onB.separation);
    if (onB.separation > onA.separation) {
        const Edges onEdgeB = edgesAt(b, onB.edge, a, magnitude);
        const bool faces = a.normal(onA.edge).dot(b.normal(onB.edge)) < -parallelCosine;
        if (!faces || onB.separation > onA.separation + onEdgeB.slack)
            return exchanged(manifoldAt(onEdgeB, best, margin));
    }
    return manifoldAt(edgesAt(a, onA.edge, b, magnitude), best, margin);
}

}  // namespace plumb
