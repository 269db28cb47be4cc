// SPDX-License-Identifier: MIT
#include <plumb/shapes/mass.h>

#include <numbers>

namespace plumb {
namespace {

Mass circleMass(const Circle& circle, double density) {
    const double square = circle.radius * circle.radius;
    const double mass = density * std::numbers::pi * square;
    return {mass, circle.center, 0.5 * mass * square};
}

// Triangles from the first corner, not from the body's origin: far from there, a sum about the origin would lose the
// polygon's own inertia in the square of the distance.
Mass polygonMass(const Polygon& polygon, double density) {
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

}  // namespace

Mass massOf(const Shape& shape, double density) {
    if (const auto* circle = std::get_if<Circle>(&shape)) return circleMass(*circle, density);
    if (const auto* polygon = std::get_if<Polygon>(&shape)) return polygonMass(*polygon, density);
    const auto& segment = std::get<Segment>(shape);
    return {0, 0.5 * (segment.start + segment.end), 0};
}

Mass combine(std::span<const Mass> parts) {
    Mass all;
    const Mass* heaviest = nullptr;
    for (const Mass& part : parts) {
        all.mass += part.mass;
        if (heaviest == nullptr || part.mass > heaviest->mass) heaviest = &part;
    }
    if (heaviest == nullptr) return all;
    all.center = heaviest->center;
    if (!(all.mass > 0)) return all;
    // Relative to one part's centre, for the same reason as a polygon's corners.
    Vec2 moment{0, 0};
    for (const Mass& part : parts) moment += part.mass * (part.center - heaviest->center);
    all.center += moment / all.mass;
    for (const Mass& part : parts) all.inertia += part.inertia + part.mass * (part.center - all.center).squaredNorm();
    return all;
}

}  // namespace plumb
