// SPDX-License-Identifier: MIT
#include <plumb/shapes/mass.h>

#include <cmath>
#include <numbers>
#include <string>

#include <plumb/math/check.h>
#include <plumb/math/trig.h>
#include <plumb/shapes/detail/checks.h>

namespace plumb {
namespace {

Mass circleMass(const Circle& circle, double density) {
    const double square = circle.radius * circle.radius;
    const double mass = density * std::numbers::pi * square;
    return {mass, circle.center, 0.5 * mass * square};
}

/// A rectangle and a disc cut into halves, half a length to either side; g is the distance of a half disc's centroid
/// from the cut.
Mass capsuleMass(const Capsule& capsule, double density) {
    const double length = (capsule.end - capsule.start).norm();
    const double r = capsule.radius;
    const double box = density * length * 2 * r;
    const double disc = density * std::numbers::pi * r * r;
    const double g = 4 * r / (3 * std::numbers::pi);
    const double boxInertia = box * (length * length + 4 * r * r) / 12;
    const double discInertia = disc * (r * r / 2 + length * length / 4 + length * g);
    return {box + disc, 0.5 * (capsule.start + capsule.end), boxInertia + discInertia};
}

// Triangles from the first corner, not from the body's origin: if the polygon is far from the origin, the square of the
// distance would swamp its own inertia.
Mass coreMass(const Polygon& polygon, double density) {
    const Vec2 first = polygon.vertices.front();
    double area = 0;
    double second = 0;
    Vec2 moment{0, 0};
    for (std::size_t i = 1; i + 1 < polygon.vertices.size(); ++i) {
        const Vec2 p = polygon.vertices[i] - first;
        const Vec2 q = polygon.vertices[i + 1] - first;
        const double a = 0.5 * cross(p, q);
        area += a;
        moment += a * (p + q) / 3;
        second += a * (p.dot(p) + p.dot(q) + q.dot(q)) / 6;
    }
    const Vec2 center = moment / area;
    return {density * area, first + center, density * (second - area * center.dot(center))};
}

/// The strip along an edge, of width radius.
Mass stripMass(const Vec2& start, const Vec2& end, const Vec2& outward, double radius, double density) {
    const Vec2 edge = end - start;
    const double mass = density * edge.norm() * radius;
    const Vec2 center = start + 0.5 * edge + 0.5 * radius * outward;
    return {mass, center, mass * (edge.squaredNorm() + radius * radius) / 12};
}

/// The sector of a disc at a corner, of angle t between the normals before and after it: area = r^2 t / 2, centroid at
/// (4 r / 3 t) sin(t / 2) from the tip, second moment about the tip r^4 t / 4.
Mass sectorMass(const Vec2& corner, const Vec2& before, const Vec2& after, double radius, double density) {
    const double angle = arcTangent(cross(before, after), before.dot(after));
    const double mass = density * radius * radius * angle / 2;
    // The difference of the normals has length 2 sin(t / 2) and is perpendicular to the sector's axis.
    const Vec2 across = after - before;
    const Vec2 out = -perp(across) * (2 * radius / (3 * angle));
    return {mass, corner + out, mass * (radius * radius / 2 - out.squaredNorm())};
}

Mass polygonMass(const Polygon& polygon, double density) {
    if (!(polygon.radius > 0)) return coreMass(polygon, density);
    const std::vector<Vec2>& corners = polygon.vertices;
    const std::size_t count = corners.size();
    std::vector<Vec2> normals;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec2 edge = corners[(i + 1) % count] - corners[i];
        normals.emplace_back(-perp(edge).stableNormalized());
    }
    std::vector<Mass> parts{coreMass(polygon, density)};
    for (std::size_t i = 0; i < count; ++i) {
        parts.push_back(stripMass(corners[i], corners[(i + 1) % count], normals[i], polygon.radius, density));
        parts.push_back(sectorMass(corners[i], normals[(i + count - 1) % count], normals[i], polygon.radius, density));
    }
    return combine(parts);
}

/// A line has no mass; its midpoint is used as its centre.
Mass lineMass(const Vec2& start, const Vec2& end) {
    return {0, 0.5 * (start + end), 0};
}

}  // namespace

Mass massOf(const Shape& shape, double density) {
    validate(shape, "massOf: shape");
    requireNotNegative(density, "massOf: density");
    if (const auto* circle = std::get_if<Circle>(&shape)) return circleMass(*circle, density);
    if (const auto* capsule = std::get_if<Capsule>(&shape)) return capsuleMass(*capsule, density);
    if (const auto* polygon = std::get_if<Polygon>(&shape)) return polygonMass(*polygon, density);
    if (const auto* segment = std::get_if<Segment>(&shape)) return lineMass(segment->start, segment->end);
    if (const auto* chain = std::get_if<Chain>(&shape)) return lineMass(chain->points.front(), chain->points.back());
    const std::array<Vec2, 4> corners = outerCornersOf(std::get<TileMap>(shape));
    return lineMass(corners[0], corners[2]);
}

Mass combine(std::span<const Mass> parts) {
    for (std::size_t i = 0; i < parts.size(); ++i) requireMass(parts[i], "combine: parts", i);
    Mass all;
    const Mass* heaviest = nullptr;
    for (const Mass& part : parts) {
        all.mass += part.mass;
        if (heaviest == nullptr || part.mass > heaviest->mass) heaviest = &part;
    }
    if (heaviest == nullptr) return all;
    all.center = heaviest->center;
    if (!(all.mass > 0)) return all;
    // Relative to one part's centre, for the same reason as in coreMass.
    Vec2 moment{0, 0};
    for (const Mass& part : parts) moment += part.mass * (part.center - heaviest->center);
    all.center += moment / all.mass;
    for (const Mass& part : parts) all.inertia += part.inertia + part.mass * (part.center - all.center).squaredNorm();
    return all;
}

}  // namespace plumb
