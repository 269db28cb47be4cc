// SPDX-License-Identifier: MIT
// What is wrong with a manifold, seen from the Minkowski difference?
#pragma once
#include <limits>
#include <optional>
#include <vector>

#include "kit/collide/placements.h"

/// A placement and what is known of it without the kit.
struct Known {
    minkowski::Outline a, b;
    minkowski::Gap gap;
    double margin = 0, size = 1;
    double favour = 0;      ///< by how much the kit may prefer A's edge to a better one of B [m]
    bool favoured = false;  ///< B has the best edge, but not by more than that
    bool clear = false;     ///< one direction is best by more than that
    double tolerance = 0;   ///< of separations and places [m]
    double cornerBlur = 0;  ///< of the direction between two corners: as good as their places, seen from so near [rad]
};

namespace manifoldCheck {

using minkowski::Outline;
using minkowski::Point;

/// Float has 6e-8; turning, shifting, subtracting and projecting coordinates of this size make about ten roundings, and
/// so does the normal that came in rounded.
inline constexpr double floatError = 1e-6;
/// Corners nearer to each other than this may get the normal of an edge: documented as the rounding of the coordinates.
inline constexpr double cornerNoise = 3e-6;
/// The part of the shorter edge by which A's is preferred; its length is taken as |x| + |y|, up to sqrt 2 of it.
inline constexpr double favourOfShorter = 1.42e-4;

/// Only edges within 0.8 degrees of each other are, 0.0142 rad.
inline constexpr double facingCosine = 0.99989;

inline Point outwardOf(const Outline& outline, std::size_t i) {
    const Point edge = edgeOf(outline.corners, i);
    return Point{edge.y, -edge.x} * (1 / length(edge));
}

inline double longestEdge(const Outline& outline) {
    double longest = 0;
    for (std::size_t i = 0; i < outline.corners.size(); ++i)
        longest = std::max(longest, length(edgeOf(outline.corners, i)));
    return longest;
}

/// The gap along an edge's normal, from A to B.
struct EdgeGap {
    double gap = 0;
    Point direction;
};

inline std::vector<EdgeGap> edgeGapsOf(const Outline& a, const Outline& b, const Outline& owner, double sign) {
    std::vector<EdgeGap> gaps;
    for (std::size_t i = 0; owner.corners.size() > 1 && i < owner.corners.size(); ++i) {
        const Point direction = outwardOf(owner, i) * sign;
        gaps.push_back({gapAlong(a, b, direction), direction});
    }
    std::sort(gaps.begin(), gaps.end(), [](const EdgeGap& x, const EdgeGap& y) { return x.gap > y.gap; });
    return gaps;
}

/// By how much A's best edge may be worse than B's best and still lend its normal: by rounding, and more if they lie
/// along each other.
inline double favourOf(const Known& k, const std::vector<EdgeGap>& onA, const std::vector<EdgeGap>& onB) {
    for (const EdgeGap& a : onA)
        for (const EdgeGap& b : onB)
            if (a.gap > onA[0].gap - k.tolerance && b.gap > onB[0].gap - k.tolerance &&
                dot(a.direction, b.direction) > facingCosine)
                return k.tolerance + favourOfShorter * std::min(longestEdge(k.a), longestEdge(k.b)) +
                       cornerNoise * k.size;
    return k.tolerance;
}

}  // namespace manifoldCheck

inline Known knownOf(const Placement& p) {
    using namespace manifoldCheck;
    Known k;
    k.a = outlineOf(p.a, {});
    k.b = outlineOf(p.b, p.bInA);
    k.gap = gapBetween(k.a, k.b);
    k.margin = p.margin;
    k.size = p.size;
    k.tolerance = floatError * p.size;
    const double coreGap = k.gap.separation + k.a.radius + k.b.radius;
    if (std::fabs(coreGap) < cornerNoise * p.size) k.tolerance += cornerNoise * p.size;
    k.cornerBlur = 2 * floatError * p.size / std::max(std::fabs(coreGap), 1e-30);
    const std::vector<EdgeGap> onA = edgeGapsOf(k.a, k.b, k.a, 1), onB = edgeGapsOf(k.a, k.b, k.b, -1);
    std::vector<double> all{-1e300, -1e300};
    for (const auto* side : {&onA, &onB})
        for (const EdgeGap& gap : *side) all.push_back(gap.gap);
    std::sort(all.rbegin(), all.rend());
    k.favour = favourOf(k, onA, onB);
    k.clear = all[0] - all[1] > 2 * k.favour;
    if (onA.empty() || onB.empty()) return k;
    k.favoured = onB[0].gap > onA[0].gap - k.tolerance && onB[0].gap < onA[0].gap + k.favour;
    return k;
}

namespace manifoldCheck {

inline Point pointOf(const plumb::Vec2f& v) {
    return {v.x(), v.y()};
}

inline bool isEdge(int code) {
    return (code & 0x80) != 0;
}

/// The ends of the stretch that the edge facing a reference edge shares with it, as separations; empty when rounding
/// decides which edge that is, whether there is a stretch, or whether an end is within the margin.
struct Stretch {
    std::vector<Point> positions;
    double steepness = 0;
};

inline std::optional<Stretch> stretchOf(const Known& k, const Outline& reference, std::size_t edge,
                                        const Outline& incident) {
    const Point normal = outwardOf(reference, edge), start = reference.corners[edge];
    const Point along = edgeOf(reference.corners, edge) * (1 / length(edgeOf(reference.corners, edge)));
    double best = 2, second = 2;
    std::size_t facing = 0;
    for (std::size_t i = 0; i < incident.corners.size(); ++i) {
        const double turn = dot(normal, outwardOf(incident, i));
        second = std::min(second, std::max(turn, best));
        if (turn >= best) continue;
        best = turn;
        facing = i;
    }
    if (second - best < 1e-5) return std::nullopt;
    // Places on the facing edge from 0 to 1, between the planes through the reference edge's ends.
    const Point from = incident.corners[facing], edgeB = edgeOf(incident.corners, facing);
    const double shorter = std::min(length(edgeOf(reference.corners, edge)), length(edgeB));
    const double slope = dot(edgeB, along);  // negative: the edges run against each other
    if (std::fabs(slope) < favourOfShorter * shorter + cornerNoise * k.size) return std::nullopt;
    const double atEnd = (length(edgeOf(reference.corners, edge)) - dot(from - start, along)) / slope;
    const double atStart = -dot(from - start, along) / slope;
    const double first = std::max(0.0, atEnd), last = std::min(1.0, atStart);
    if ((last - first) * std::fabs(slope) < favourOfShorter * shorter + cornerNoise * k.size) return std::nullopt;

    Stretch stretch;
    stretch.steepness = length(edgeB) / std::fabs(slope);
    for (const double part : {first, last}) {
        const Point onIncident = from + edgeB * part;
        const double separation = dot(onIncident - start, normal) - reference.radius - incident.radius;
        if (std::fabs(separation - k.margin) < k.tolerance * stretch.steepness) return std::nullopt;
        if (separation > k.margin) continue;
        stretch.positions.push_back(onIncident - normal * (incident.radius + separation / 2));
    }
    return stretch;
}

/// The edge whose normal a manifold has.
struct Reference {
    bool isA = false;
    std::size_t edge = 0;
    double off = 1e300;  ///< of its direction [rad]
    double blur = 0;     ///< corners that were rounded to float give a short edge no better direction [rad]
};

inline Reference referenceOf(const Known& k, Point normal) {
    Reference best;
    for (const bool isA : {true, false}) {
        const Outline& outline = isA ? k.a : k.b;
        for (std::size_t i = 0; i < outline.corners.size(); ++i) {
            const double off = length(outwardOf(outline, i) * (isA ? 1 : -1) - normal);
            const double blur = floatError + 0.2 * floatError * k.size / length(edgeOf(outline.corners, i));
            if (off < best.off) best = {isA, i, off, blur};
        }
    }
    return best;
}

inline const char* faultOfStretch(const Known& k, const plumb::Manifold& m) {
    const Reference reference = referenceOf(k, pointOf(m.normal));
    if (reference.off > reference.blur) return "the normal is not that of an edge";
    const std::optional<Stretch> stretch = reference.isA ? stretchOf(k, k.a, reference.edge, k.b)  //
                                                         : stretchOf(k, k.b, reference.edge, k.a);
    if (!stretch) return nullptr;
    if (static_cast<int>(stretch->positions.size()) != m.count)
        return "count differs from the ends of the shared stretch";
    for (std::size_t i = 0; i < stretch->positions.size(); ++i) {
        double nearest = 1e300;
        for (const Point p : stretch->positions) nearest = std::min(nearest, length(p - pointOf(m.points[i].position)));
        if (nearest > k.tolerance * (1 + stretch->steepness)) return "a point is not at an end of the shared stretch";
    }
    return nullptr;
}

/// How far a point is from the edge that a feature's code names, or across the normal from the corner; infinite if
/// there is none.
inline double distanceToFeature(const std::vector<Point>& corners, int code, Point p, Point normal) {
    const std::size_t index = static_cast<std::size_t>(code & 0x7f);
    if (index >= corners.size()) return std::numeric_limits<double>::infinity();
    if (!isEdge(code)) return std::fabs(cross(normal, p - corners[index]));
    return length(p - nearestOnSegment(p, corners[index], edgeOf(corners, index)));
}

/// A point lies at the corner and on the edge that it is named after; less than the slack is not cut off the name.
inline const char* faultOfFeatures(const Known& k, const plumb::Manifold& m) {
    if (m.count == 2 && m.points[0].feature == m.points[1].feature) return "both points have the same feature";
    const double slack = favourOfShorter * std::min(longestEdge(k.a), longestEdge(k.b)) + cornerNoise * k.size;
    const Point normal = pointOf(m.normal);
    for (std::size_t i = 0; i < static_cast<std::size_t>(m.count); ++i) {
        const plumb::ManifoldPoint& point = m.points[i];
        const int codeA = point.feature >> 8, codeB = point.feature & 0xff;
        if (isEdge(codeA) && isEdge(codeB)) return "an edge cannot meet an edge in one point";
        const Point onA = pointOf(point.position) - normal * (point.separation / 2.0 + k.a.radius);
        const Point onB = pointOf(point.position) + normal * (point.separation / 2.0 + k.b.radius);
        if (distanceToFeature(k.a.corners, codeA, onA, normal) > k.tolerance + slack) return "not at A's feature";
        if (distanceToFeature(k.b.corners, codeB, onB, normal) > k.tolerance + slack) return "not at B's feature";
    }
    return nullptr;
}

inline const char* faultOfPoints(const Known& k, const plumb::Manifold& m, double tolerance) {
    const Point normal = pointOf(m.normal);
    const double reach = tolerance + cornerNoise * k.size;  // past the end of a face by so little is not clipped
    for (std::size_t i = 0; i < static_cast<std::size_t>(m.count); ++i) {
        const plumb::ManifoldPoint& point = m.points[i];
        if (!(point.separation <= k.margin)) return "a point beyond the margin";
        const Point onA = pointOf(point.position) - normal * (point.separation / 2.0 + k.a.radius);
        const Point onB = pointOf(point.position) + normal * (point.separation / 2.0 + k.b.radius);
        if (distanceToBoundary(k.a.corners, onA) > reach) return "a point off A's surface";
        if (distanceToBoundary(k.b.corners, onB) > reach) return "a point off B's surface";
    }
    return nullptr;
}

}  // namespace manifoldCheck

/// Circles have no features: theirs may be.
inline bool isBetweenCorners(const plumb::Manifold& m) {
    return (m.points[0].feature & 0x8080) == 0;
}

inline double leastSeparation(const plumb::Manifold& m) {
    float least = m.points[0].separation;
    if (m.count == 2) least = std::min(least, m.points[1].separation);
    return least;
}

/// Null when the manifold is right.
inline const char* faultOf(const Known& k, const plumb::Manifold& m) {
    using namespace manifoldCheck;
    const double tolerance = k.tolerance + (k.favoured ? k.favour : 0);
    if (m.count == 0) return k.gap.separation > k.margin - tolerance ? nullptr : "no contact within the margin";
    if (k.gap.separation > k.margin + tolerance) return "a contact beyond the margin";
    const Point normal = pointOf(m.normal);
    if (std::fabs(length(normal) - 1) > 1e-6) return "the normal is not a unit vector";
    const double blur = isBetweenCorners(m) ? k.cornerBlur : 0;
    const double tilt = blur * std::max(longestEdge(k.a), longestEdge(k.b));
    if (gapAlong(k.a, k.b, normal) < k.gap.separation - tolerance - tilt)
        return "the normal is not the way that parts them";
    const double least = leastSeparation(m);
    if (std::fabs(least - k.gap.separation) > tolerance) return "the least separation is not the gap";
    const double left = gapBetween(k.a, shifted(k.b, normal * -least)).separation;
    if (std::fabs(left) > tolerance + blur * std::fabs(least)) return "moved by the separation they do not just touch";
    if (const char* fault = faultOfPoints(k, m, tolerance)) return fault;
    if (k.a.corners.size() == 1 || k.b.corners.size() == 1) return nullptr;
    if (const char* fault = faultOfFeatures(k, m)) return fault;
    return isBetweenCorners(m) ? (m.count == 1 ? nullptr : "two corners meet in two points") : faultOfStretch(k, m);
}
