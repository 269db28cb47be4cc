// SPDX-License-Identifier: MIT
#include <plumb/shapes/hull.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <plumb/math/check.h>

namespace plumb {
namespace {

/// A little more than what a polygon is held to, so that rounding does not make it refuse what comes from here.
constexpr double hullTolerance = 1.5e-6;

using Indices = std::vector<std::size_t>;

/// Points from the first one, times a power of two, so that products of huge or tiny lengths neither overflow nor
/// vanish.
std::vector<Vec2> scaledPoints(std::span<const Vec2> points) {
    double largest = 0;
    for (const Vec2& p : points) largest = std::max({largest, std::fabs(p.x()), std::fabs(p.y())});
    int exponent = 0;
    std::frexp(largest, &exponent);
    std::vector<Vec2> scaled;
    scaled.reserve(points.size());
    for (const Vec2& p : points) scaled.emplace_back(std::ldexp(p.x(), -exponent), std::ldexp(p.y(), -exponent));
    const Vec2 first = scaled.front();
    for (Vec2& p : scaled) p -= first;
    return scaled;
}

/// Andrew's monotone chain: the lower outline from left to right, then the upper one back.
Indices outlineOf(const std::vector<Vec2>& points) {
    Indices sorted(points.size());
    std::iota(sorted.begin(), sorted.end(), std::size_t{0});
    std::sort(sorted.begin(), sorted.end(), [&](std::size_t a, std::size_t b) {
        if (points[a].x() != points[b].x()) return points[a].x() < points[b].x();
        return points[a].y() != points[b].y() ? points[a].y() < points[b].y() : a < b;
    });
    Indices hull;
    const auto add = [&](std::size_t index, std::size_t least) {
        const auto turnsLeft = [&] {
            const Vec2& end = points[hull.back()];
            const Vec2 in = end - points[hull[hull.size() - 2]], out = points[index] - end;
            return cross(in, out) > 0;
        };
        while (hull.size() > least && !turnsLeft()) hull.pop_back();
        hull.push_back(index);
    };
    for (const std::size_t index : sorted) add(index, 1);
    const std::size_t lower = hull.size();
    for (std::size_t i = sorted.size() - 1; i-- > 0;) add(sorted[i], lower);
    hull.pop_back();  // the first again
    return hull;
}

double extentOf(const std::vector<Vec2>& points) {
    Vec2 lower = points.front(), upper = points.front();
    for (const Vec2& p : points) {
        lower = lower.cwiseMin(p);
        upper = upper.cwiseMax(p);
    }
    return (upper - lower).norm();
}

/// One round along the outline without the corners that are hardly any: too near to the one before, or hardly a turn.
Indices withoutFlats(const Indices& outline, const std::vector<Vec2>& points, double shortest) {
    Indices kept;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const std::size_t before = kept.empty() ? outline.back() : kept.back();
        const std::size_t after = i + 1 < outline.size() ? outline[i + 1] : (kept.empty() ? before : kept.front());
        const Vec2 in = points[outline[i]] - points[before];
        const Vec2 out = points[after] - points[outline[i]];
        const bool corner = in.norm() > shortest && cross(in, out) > hullTolerance * in.norm() * out.norm();
        if (corner) kept.push_back(outline[i]);
    }
    return kept;
}

}  // namespace

Polygon hullOf(std::span<const Vec2> points) {
    for (std::size_t i = 0; i < points.size(); ++i)
        if (!points[i].allFinite()) requireFinite(points[i], "hullOf.points[" + std::to_string(i) + "]");
    Indices hull;
    if (!points.empty()) {
        const std::vector<Vec2> scaled = scaledPoints(points);
        const double shortest = hullTolerance * extentOf(scaled);
        hull = outlineOf(scaled);
        for (std::size_t before = hull.size() + 1; hull.size() < before;) {
            before = hull.size();
            hull = withoutFlats(hull, scaled, shortest);
        }
    }
    const std::string made =
        std::to_string(hull.size()) + " corners, made of " + std::to_string(points.size()) + " points, are ";
    if (hull.size() < 3) refuse("hullOf.points", made + "fewer than 3");
    if (hull.size() > static_cast<std::size_t>(maxPolygonVertices))
        refuse("hullOf.points", made + "more than " + std::to_string(maxPolygonVertices));
    Polygon polygon;
    for (const std::size_t index : hull) polygon.vertices.push_back(points[index]);
    return polygon;
}

}  // namespace plumb
