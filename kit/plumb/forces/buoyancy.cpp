// SPDX-License-Identifier: MIT
#include <plumb/forces/buoyancy.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <plumb/forces/detail/require_numbers.h>
#include <plumb/math/check.h>
#include <plumb/math/trig.h>

namespace plumb {
namespace {

constexpr double pi = std::numbers::pi;

/// Axes along and across the surface, from a point of it.
struct Frame {
    Vec2 origin{0, 0}, right{1, 0}, up{0, 1};

    Vec2 local(const Vec2& p) const { return {right.dot(p - origin), up.dot(p - origin)}; }
    Vec2 world(const Vec2& p) const { return origin + p.x() * right + p.y() * up; }
};

/// Moments of the part below y = 0: each is a sum over the lines and arcs of its outline.
struct Moments {
    double area = 0, x = 0, y = 0;

    void addLine(const Vec2& a, const Vec2& b);
    void addArc(const Vec2& center, double radius, double start, double end);
};

void Moments::addLine(const Vec2& a, const Vec2& b) {
    const double dx = b.x() - a.x();
    area -= dx * (a.y() + b.y()) / 2;
    x -= dx * (a.x() * (2 * a.y() + b.y()) + b.x() * (a.y() + 2 * b.y())) / 6;
    y -= dx * (a.y() * a.y() + a.y() * b.y() + b.y() * b.y()) / 6;
}

// x = cx + r cos t, y = cy + r sin t, dx = -r sin t dt; the integrals of sin^m t cos^n t from start to end.
void Moments::addArc(const Vec2& center, double radius, double start, double end) {
    const SinCos s = sinCos(start), e = sinCos(end);
    const double sin1 = s.cos - e.cos;
    const double sin2 = ((end - start) - (e.sin * e.cos - s.sin * s.cos)) / 2;
    const double sin3 = sin1 - (s.cos * s.cos * s.cos - e.cos * e.cos * e.cos) / 3;
    const double sinCos1 = (e.sin * e.sin - s.sin * s.sin) / 2;
    const double sin2Cos = (e.sin * e.sin * e.sin - s.sin * s.sin * s.sin) / 3;
    const double r = radius, cy = center.y();
    const double part = r * (cy * sin1 + r * sin2);
    area += part;
    x += center.x() * part + r * r * (cy * sinCos1 + r * sin2Cos);
    y += r * (cy * cy * sin1 + r * (2 * cy * sin2 + r * sin3)) / 2;
}

void addLineBelow(Moments& sum, Vec2 a, Vec2 b) {
    if (a.y() >= 0 && b.y() >= 0) return;
    const auto cut = [&a, &b] { return Vec2(a.x() + (b.x() - a.x()) * (a.y() / (a.y() - b.y())), 0); };
    const Vec2 met = a.y() > 0 || b.y() > 0 ? cut() : a;
    if (a.y() > 0) a = met;
    if (b.y() > 0) b = met;
    sum.addLine(a, b);
}

/// The arc is below the surface where its angle is within (pi - crossing, 2 pi + crossing), plus whole turns.
void addArcBelow(Moments& sum, const Vec2& center, double radius, double start, double arcAngle) {
    if (center.y() - radius >= 0) return;
    if (center.y() + radius <= 0) return sum.addArc(center, radius, start, start + arcAngle);
    const double sine = -center.y() / radius;
    const double crossing = arcTangent(sine, std::sqrt((1 - sine) * (1 + sine)));
    for (int turn = -2; turn <= 1; ++turn) {
        const double from = std::max(start, pi - crossing + 2 * pi * turn);
        const double to = std::min(start + arcAngle, 2 * pi + crossing + 2 * pi * turn);
        if (from < to) sum.addArc(center, radius, from, to);
    }
}

/// An outline as submergedPart takes it, in the frame of the surface.
struct Outline {
    std::span<const Vec2> corners;
    double radius;
    Frame frame;

    Vec2 at(std::size_t i) const { return frame.local(corners[i % corners.size()]); }
    /// Normal of the edge that starts at corner i.
    Vec2 outward(std::size_t i) const {
        const Vec2 edge = at(i + 1) - at(i);
        return -perp(edge).normalized();
    }
};

void requireSound(const Outline& outline) {
    for (const Vec2& corner : outline.corners) requireFinite(corner, "submergedPart: corners");
    requireNotNegative(outline.radius, "submergedPart: radius");
    if (outline.radius == 0 || outline.corners.size() < 2) return;
    for (std::size_t i = 0; i < outline.corners.size(); ++i) {
        const Vec2 normal = outline.outward(i), next = outline.outward(i + 1);
        if (normal.isZero(0) || cross(normal, next) < -1e-9)
            refuse("submergedPart: corners", "with a radius, they must be convex and counter-clockwise");
    }
}

struct Bounds {
    Vec2 low, high;
};

Bounds boundsOf(const Outline& outline) {
    Bounds bounds{outline.at(0), outline.at(0)};
    for (std::size_t i = 1; i < outline.corners.size(); ++i) {
        bounds.low = bounds.low.cwiseMin(outline.at(i));
        bounds.high = bounds.high.cwiseMax(outline.at(i));
    }
    const Vec2 margin(outline.radius, outline.radius);
    return {bounds.low - margin, bounds.high + margin};
}

/// The angle from one edge's normal to the next one's, counter-clockwise.
double arcAngleBetween(const Vec2& from, const Vec2& to) {
    const double angle = arcTangent(cross(from, to), from.dot(to));
    // Half a turn around the ends of a capsule, which rounding may report as -half a turn.
    return angle < -pi / 2 ? angle + 2 * pi : std::max(0.0, angle);
}

Moments momentsBelow(const Outline& outline) {
    Moments sum;
    if (outline.corners.size() == 1) {
        addArcBelow(sum, outline.at(0), outline.radius, 0, 2 * pi);
        return sum;
    }
    for (std::size_t i = 0; i < outline.corners.size(); ++i) {
        const Vec2 a = outline.at(i), b = outline.at(i + 1);
        if (outline.radius == 0) {
            addLineBelow(sum, a, b);
            continue;
        }
        const Vec2 normal = outline.outward(i), next = outline.outward(i + 1);
        addLineBelow(sum, a + outline.radius * normal, b + outline.radius * normal);
        addArcBelow(sum, b, outline.radius, arcTangent(normal.y(), normal.x()), arcAngleBetween(normal, next));
    }
    return sum;
}

void requireSound(const Fluid& fluid) {
    requireNumbers(fluid);
}

}  // namespace

Submerged submergedPart(std::span<const Vec2> corners, double radius, const Fluid& fluid) {
    requireSound(fluid);
    requireSound(Outline{corners, radius, {}});
    return submergedPartOf(corners, radius, fluid);
}

Submerged submergedPartOf(std::span<const Vec2> corners, double radius, const Fluid& fluid) {
    const double strength = fluid.gravity.norm();
    Outline outline{corners, radius, {}};
    if (corners.empty() || strength == 0) return {};

    // The frame's origin is near the outline, and at its top when all of it is below: numbers stay small, however far
    // and deep it is.
    const Vec2 up = -fluid.gravity / strength;
    outline.frame = {corners[0] - up.dot(corners[0] - fluid.surface) * up, -perp(up), up};
    const Bounds bounds = boundsOf(outline);
    const double over = std::max(0.0, -bounds.high.y());
    outline.frame.origin -= over * up;

    const Moments sum = momentsBelow(outline);
    const Vec2 size = bounds.high - bounds.low;
    if (!(std::fabs(sum.area) > 1e-12 * size.squaredNorm())) return {};
    const Vec2 centroid(sum.x / sum.area, sum.y / sum.area);
    return {std::fabs(sum.area), outline.frame.world(centroid), over - centroid.y()};
}

Vec2 buoyancyForce(const Fluid& fluid, const Submerged& part) {
    requireSound(fluid);
    return -fluid.density * part.area * fluid.gravity;
}

double potentialEnergy(const Fluid& fluid, const Submerged& part) {
    requireSound(fluid);
    return fluid.density * fluid.gravity.norm() * part.area * part.depth;
}

}  // namespace plumb
