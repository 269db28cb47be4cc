// SPDX-License-Identifier: MIT
// Which placements of two shapes put collision code to the test?
#pragma once
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include <plumb/collide/manifold.h>
#include <plumb/math/random.h>

#include "kit/collide/minkowski.h"

enum class Kind { Circle, Polygon, Box, Segment, Capsule, RoundedPolygon };
inline constexpr std::array kinds{Kind::Circle,  Kind::Polygon, Kind::Box,
                                  Kind::Segment, Kind::Capsule, Kind::RoundedPolygon};

inline std::string nameOf(Kind kind) {
    constexpr std::array names{"circle", "polygon", "box", "segment", "capsule", "rounded polygon"};
    return names[static_cast<std::size_t>(kind)];
}

/// x first, then y, with every compiler: arguments of one call may be drawn in any order.
inline plumb::Vec2 randomVec2(plumb::Random& random, double reach) {
    const double x = random.uniform(-reach, reach);
    const double y = random.uniform(-reach, reach);
    return {x, y};
}

/// Corners on a turned ellipse away from the origin: convex, 3 to 8 of them, in 1 of 16 up to 64, thin ones among them.
inline plumb::Polygon randomPolygon(plumb::Random& random, double scale) {
    const int most = random.integer(0, 15) == 0 ? plumb::maxPolygonVertices : 8;
    const int count = random.integer(3, most);
    const double wide = scale * random.uniform(0.3, 1), high = scale * random.uniform(0.1, 1);
    const double turn = random.uniform(0, 2 * std::numbers::pi);
    const plumb::Vec2 center = randomVec2(random, scale);
    plumb::Polygon polygon;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * (i + random.uniform(0, 0.8)) / count;
        const double x = wide * std::cos(angle), y = high * std::sin(angle);
        polygon.vertices.push_back(center + plumb::Vec2(x * std::cos(turn) - y * std::sin(turn),  //
                                                        x * std::sin(turn) + y * std::cos(turn)));
    }
    return polygon;
}

inline plumb::Shape randomShape(plumb::Random& random, Kind kind, double scale) {
    if (kind == Kind::Polygon || kind == Kind::RoundedPolygon) {
        plumb::Polygon polygon = randomPolygon(random, scale);
        if (kind == Kind::RoundedPolygon) polygon.radius = scale * random.uniform(0.01, 0.5);
        return polygon;
    }
    if (kind == Kind::Circle) {
        const double radius = scale * random.uniform(0.1, 1);
        return plumb::Circle{radius, randomVec2(random, scale)};
    }
    if (kind == Kind::Box) {
        const double halfWidth = scale * random.uniform(0.1, 1), halfHeight = scale * random.uniform(0.1, 1);
        return plumb::boxPolygon({halfWidth, halfHeight});
    }
    const plumb::Vec2 start = randomVec2(random, scale);
    const double angle = random.uniform(0, 2 * std::numbers::pi), length = scale * random.uniform(0.3, 2);
    const plumb::Vec2 end = start + length * plumb::Vec2(std::cos(angle), std::sin(angle));
    if (kind == Kind::Capsule) return plumb::Capsule{start, end, scale * random.uniform(0.01, 0.5)};
    return plumb::Segment{start, end};
}

inline Kind randomKind(plumb::Random& random) {
    return kinds[static_cast<std::size_t>(random.integer(0, static_cast<int>(kinds.size()) - 1))];
}

inline plumb::Convex randomConvex(plumb::Random& random, Kind kind, double scale) {
    return plumb::convexOf(randomShape(random, kind, scale), {0, 0});
}

/// A core as it lies, in double: the very numbers that the float code gets.
inline minkowski::Outline outlineOf(const plumb::Convex& convex, const plumb::RelativePose& pose) {
    minkowski::Outline outline;
    outline.radius = convex.radius;
    const double c = pose.cos, s = pose.sin;
    for (std::size_t i = 0; i < static_cast<std::size_t>(convex.count); ++i) {
        const double x = convex.vertices[i].x(), y = convex.vertices[i].y();
        outline.corners.push_back({c * x - s * y + pose.position.x(), s * x + c * y + pose.position.y()});
    }
    return outline;
}

enum class Regime { Deep, Touching, Near, Shallow, Far, Corners, Flush, Degenerate };
inline constexpr int regimes = 8;

struct Placement {
    plumb::Convex a, b;
    plumb::RelativePose bInA;
    Regime regime = Regime::Near;
    float margin = 0;
    double size = 1;  ///< of the numbers that go in: corners, radii, place [m]
};

namespace placements {

inline minkowski::Point cornerOf(plumb::Random& random, const minkowski::Outline& outline) {
    return outline.corners[static_cast<std::size_t>(random.integer(0, static_cast<int>(outline.corners.size()) - 1))];
}

/// Puts a corner of b on a corner of a.
inline minkowski::Point cornerOnCorner(plumb::Random& random, const minkowski::Outline& a,
                                       const minkowski::Outline& b) {
    const minkowski::Point onA = cornerOf(random, a);
    return onA - cornerOf(random, b);
}

inline minkowski::Point middleOf(const minkowski::Outline& outline) {
    minkowski::Point sum;
    for (const minkowski::Point p : outline.corners) sum = sum + p;
    return sum * (1.0 / static_cast<double>(outline.corners.size()));
}

inline minkowski::Point aside(plumb::Random& random, double length) {
    const double angle = random.uniform(0, 2 * std::numbers::pi);
    return {length * std::cos(angle), length * std::sin(angle)};
}

/// Where to put b, which lies turned about the origin, so that the gap to a becomes what is wanted.
inline minkowski::Point placeAtGap(plumb::Random& random, const minkowski::Outline& a, const minkowski::Outline& b,
                                   double wanted, double scale) {
    minkowski::Point place = middleOf(a) - middleOf(b) + aside(random, 4 * scale);
    for (int i = 0; i < 4; ++i) {
        const minkowski::Gap gap = gapBetween(a, shifted(b, place));
        place = place + gap.normal * (wanted - gap.separation);
    }
    return place;
}

inline double powerOfTen(plumb::Random& random, double low, double high) {
    return std::pow(10, random.uniform(low, high));
}

/// The angle that lays an edge of b against an edge of a, and how far to tilt it from there.
inline double flushAngle(plumb::Random& random, const minkowski::Outline& a, const minkowski::Outline& b) {
    const auto angleOf = [&](const minkowski::Outline& outline) {
        const int last = static_cast<int>(outline.corners.size()) - 1;
        const minkowski::Point edge = edgeOf(outline.corners, static_cast<std::size_t>(random.integer(0, last)));
        return std::atan2(edge.y, edge.x);
    };
    const double facing = angleOf(a) + std::numbers::pi;
    const int way = random.integer(-1, 1);
    const double tilt = random.integer(0, 2) == 0 ? 0 : way * powerOfTen(random, -8, -1);
    return facing - angleOf(b) + tilt;
}

inline minkowski::Point place(plumb::Random& random, Regime regime, const minkowski::Outline& a,
                              const minkowski::Outline& b, double scale) {
    switch (regime) {
        case Regime::Deep: return middleOf(a) - middleOf(b) + aside(random, scale * random.uniform(0, 0.5));
        case Regime::Touching: return placeAtGap(random, a, b, 0, scale);
        case Regime::Near: return placeAtGap(random, a, b, scale * random.uniform(0, 0.05), scale);
        case Regime::Shallow: return placeAtGap(random, a, b, scale * random.uniform(-0.02, 0), scale);
        case Regime::Far: return placeAtGap(random, a, b, scale * random.uniform(0.1, 5), scale);
        case Regime::Corners: break;
        case Regime::Flush: return placeAtGap(random, a, b, scale * random.uniform(-0.01, 0.01), scale);
        case Regime::Degenerate: break;
    }
    const minkowski::Point corners = cornerOnCorner(random, a, b);
    if (regime == Regime::Corners) return corners + aside(random, scale * powerOfTen(random, -8, 0));
    const std::array places{minkowski::Point{0, 0}, middleOf(a) - middleOf(b), corners,
                            minkowski::Point{std::ldexp(1, random.integer(-3, 1)), 0}};
    return places[static_cast<std::size_t>(random.integer(0, 3))];
}

}  // namespace placements

inline double largestNumber(const plumb::Convex& convex) {
    double largest = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(convex.count); ++i)
        largest = std::max(largest, static_cast<double>(convex.vertices[i].norm()) + convex.radius);
    return largest;
}

/// Shapes of 0.05 to 5 m in one of the regimes; equal shapes and quarter turns among the degenerate ones.
inline Placement randomPlacement(plumb::Random& random, Kind kindA, Kind kindB) {
    Placement p;
    p.regime = static_cast<Regime>(random.integer(0, regimes - 1));
    const double scale = 0.05 * std::pow(100, random.uniform(0, 1));
    p.a = randomConvex(random, kindA, scale);
    p.b = randomConvex(random, kindB, scale * random.uniform(0.3, 3));
    if (p.regime == Regime::Degenerate && kindA == kindB && random.integer(0, 1) == 0) p.b = p.a;
    const minkowski::Outline a = outlineOf(p.a, {});

    double angle = random.uniform(0, 2 * std::numbers::pi);
    if (p.regime == Regime::Flush) angle = placements::flushAngle(random, a, outlineOf(p.b, {}));
    p.bInA.cos = static_cast<float>(std::cos(angle));
    p.bInA.sin = static_cast<float>(std::sin(angle));
    if (p.regime == Regime::Degenerate) {
        const std::array<float, 5> quarter{1, 0, -1, 0, 1};
        const std::size_t turns = static_cast<std::size_t>(random.integer(0, 3));
        p.bInA.cos = quarter[turns];
        p.bInA.sin = -quarter[turns + 1];
    }
    const minkowski::Point place = placements::place(random, p.regime, a, outlineOf(p.b, p.bInA), scale);
    p.bInA.position = {static_cast<float>(place.x), static_cast<float>(place.y)};

    const std::array<double, 4> margins{0, 0.02 * scale, scale, 10};
    p.margin = static_cast<float>(margins[static_cast<std::size_t>(random.integer(0, 3))]);
    p.size = largestNumber(p.a) + largestNumber(p.b) + static_cast<double>(p.bInA.position.norm());
    return p;
}
