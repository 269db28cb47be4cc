// SPDX-License-Identifier: MIT
// How far apart are two convex outlines, by a way that the kit does not go? By the hull of their Minkowski difference.
// Nothing here uses an edge normal of a shape, a separating axis or a clip.
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace minkowski {

struct Point {
    double x = 0, y = 0;
};

inline Point operator+(Point a, Point b) {
    return {a.x + b.x, a.y + b.y};
}
inline Point operator-(Point a, Point b) {
    return {a.x - b.x, a.y - b.y};
}
inline Point operator*(Point a, double s) {
    return {a.x * s, a.y * s};
}
inline double dot(Point a, Point b) {
    return a.x * b.x + a.y * b.y;
}
inline double cross(Point a, Point b) {
    return a.x * b.y - a.y * b.x;
}
inline double length(Point a) {
    return std::hypot(a.x, a.y);
}

/// A convex core, counter-clockwise, and the radius around it.
struct Outline {
    std::vector<Point> corners;
    double radius = 0;
};

inline Point edgeOf(const std::vector<Point>& corners, std::size_t i) {
    return corners[(i + 1) % corners.size()] - corners[i];
}

/// Andrew's monotone chain: corners of the convex hull, counter-clockwise.
inline std::vector<Point> hullOf(std::vector<Point> points) {
    std::sort(points.begin(), points.end(), [](Point a, Point b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    std::vector<Point> hull(2 * points.size());
    std::size_t n = 0;
    const auto add = [&](Point p, std::size_t least) {
        while (n >= least && cross(hull[n - 1] - hull[n - 2], p - hull[n - 1]) <= 0) --n;
        hull[n++] = p;
    };
    for (const Point p : points) add(p, 2);
    const std::size_t upper = n + 1;
    for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], upper);
    hull.resize(std::max<std::size_t>(n - 1, 1));
    return hull;
}

inline Point nearestOnSegment(Point p, Point from, Point edge) {
    const double whole = dot(edge, edge);
    return whole > 0 ? from + edge * std::clamp(dot(p - from, edge) / whole, 0.0, 1.0) : from;
}

/// How far a point is from the line around the core.
inline double distanceToBoundary(const std::vector<Point>& corners, Point p) {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < corners.size(); ++i)
        best = std::min(best, length(p - nearestOnSegment(p, corners[i], edgeOf(corners, i))));
    return best;
}

struct Gap {
    double separation = 0;  ///< negative: the least shift of B along normal that parts them
    Point normal{0, 1};     ///< from A to B
};

/// Segments in line make a hull of no width: it has an outline and no inside.
inline bool hasInside(const std::vector<Point>& hull) {
    double area = 0, outline = 0;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        area += cross(hull[i], hull[(i + 1) % hull.size()]) / 2;
        outline += length(edgeOf(hull, i));
    }
    return area > 1e-13 * outline * outline;
}

/// B - A holds the origin just when the two overlap; the nearest point of its outline is the way out, or in.
inline Gap gapBetween(const Outline& a, const Outline& b) {
    std::vector<Point> differences;
    differences.reserve(a.corners.size() * b.corners.size());
    for (const Point q : b.corners)
        for (const Point p : a.corners) differences.push_back(q - p);
    const std::vector<Point> hull = hullOf(differences);

    double deepest = -std::numeric_limits<double>::infinity(), nearest = std::numeric_limits<double>::infinity();
    Point outward{0, -1}, way{0, 0};
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Point edge = edgeOf(hull, i), q = nearestOnSegment({0, 0}, hull[i], edge);
        if (length(q) < nearest) {
            nearest = length(q);
            way = q;
        }
        if (!(length(edge) > 0)) continue;
        const double outside = cross(edge, hull[i]) / length(edge);
        if (outside > deepest) {
            deepest = outside;
            outward = Point{edge.y, -edge.x} * (1 / length(edge));
        }
    }
    const double radii = a.radius + b.radius;
    if (deepest < 0 && hasInside(hull)) return {deepest - radii, outward * -1};
    return {nearest - radii, nearest > 1e-13 ? way * (1 / nearest) : outward * -1};
}

/// How far B is ahead of A along a direction: never more than the gap, and the gap for the best direction.
inline double gapAlong(const Outline& a, const Outline& b, Point direction) {
    double endOfA = -std::numeric_limits<double>::infinity(), startOfB = std::numeric_limits<double>::infinity();
    for (const Point p : a.corners) endOfA = std::max(endOfA, dot(direction, p));
    for (const Point p : b.corners) startOfB = std::min(startOfB, dot(direction, p));
    return startOfB - endOfA - a.radius - b.radius;
}

inline Outline shifted(Outline outline, Point by) {
    for (Point& p : outline.corners) p = p + by;
    return outline;
}

}  // namespace minkowski
