// SPDX-License-Identifier: MIT
#include <plumb/shapes/mass.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <plumb/math/random.h>
#include <plumb/math/rot.h>

#include "catch.h"

using namespace plumb;

namespace {

/// The part of a level line inside a shape.
struct Chord {
    double left, right;
};

/// Integrals of 1, (x, y) and x^2 + y^2 over a shape, about a point.
struct Moments {
    double area = 0;
    Vec2 first{0, 0};
    double second = 0;

    // One chord's share: its inner integrals in closed form, weight its height.
    void hold(const Chord& chord, double y, double weight) {
        const double width = chord.right - chord.left;
        area += weight * width;
        first.x() += weight * (chord.right * chord.right - chord.left * chord.left) / 2;
        first.y() += weight * width * y;
        second += weight * ((std::pow(chord.right, 3) - std::pow(chord.left, 3)) / 3 + width * y * y);
    }
};

Mass massFrom(const Moments& m, const Vec2& about, double density) {
    const Vec2 center = m.first / m.area;
    return {density * m.area, about + center, density * (m.second - m.area * center.squaredNorm())};
}

Chord chordAt(const std::vector<Vec2>& corners, double y) {
    Chord chord{1e300, -1e300};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2& p = corners[i];
        const Vec2& q = corners[(i + 1) % corners.size()];
        if ((p.y() < y) == (q.y() < y)) continue;
        const double x = p.x() + (y - p.y()) / (q.y() - p.y()) * (q.x() - p.x());
        chord = {std::min(chord.left, x), std::max(chord.right, x)};
    }
    return chord;
}

// Level lines between two neighbouring heights of corners cut the same two edges: what is integrated is a polynomial
// of third degree in y there, for which Gauss's rule with three lines is exact.
Mass integrated(const Polygon& polygon, double density) {
    Vec2 about{0, 0};
    for (const Vec2& v : polygon.vertices) about += v / static_cast<double>(polygon.vertices.size());
    std::vector<Vec2> corners;
    std::vector<double> heights;
    for (const Vec2& v : polygon.vertices) {
        corners.push_back(v - about);
        heights.push_back(corners.back().y());
    }
    std::sort(heights.begin(), heights.end());
    Moments moments;
    for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
        const double middle = (heights[i] + heights[i + 1]) / 2;
        const double half = (heights[i + 1] - heights[i]) / 2;
        if (half <= 0) continue;
        const double reach = half * std::sqrt(0.6);
        for (const auto& [y, weight] :
             {std::pair{middle - reach, 5.0 / 9}, {middle, 8.0 / 9}, {middle + reach, 5.0 / 9}})
            moments.hold(chordAt(corners, y), y, weight * half);
    }
    return massFrom(moments, about, density);
}

// Level lines at y = r sin a, a in equal steps: the integrand is periodic, so that the trapezoid rule is exact.
Mass integrated(const Circle& circle, double density) {
    Moments moments;
    const int lines = 64;
    for (int i = 0; i < lines; ++i) {
        const double angle = (i + 0.5) / lines * std::numbers::pi - std::numbers::pi / 2;
        const double reach = circle.radius * std::cos(angle);
        moments.hold({-reach, reach}, circle.radius * std::sin(angle), reach * std::numbers::pi / lines);
    }
    return massFrom(moments, circle.center, density);
}

/// The core's corners and edges, moved outward by the radius: the rims of discs, and lines that touch them.
Chord roundedChordAt(const std::vector<Vec2>& corners, double radius, double y) {
    Chord chord{1e300, -1e300};
    const auto hold = [&](double x) { chord = {std::min(chord.left, x), std::max(chord.right, x)}; };
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2& p = corners[i];
        const Vec2 edge = corners[(i + 1) % corners.size()] - p;
        const double above = y - p.y(), square = radius * radius - above * above;
        if (square >= 0) {
            hold(p.x() - std::sqrt(square));
            hold(p.x() + std::sqrt(square));
        }
        const Vec2 outward = Vec2(edge.y(), -edge.x()) / edge.norm();
        const double part = (above - radius * outward.y()) / edge.y();
        if (part >= 0 && part <= 1) hold(p.x() + radius * outward.x() + part * edge.x());
    }
    return chord;
}

// Level lines at equal steps of an angle a, y = middle + reach sin a: dense where the outline is level, so that what is
// integrated is periodic, and smooth but for kinks in its second derivative: the trapezoid rule's error is of the order
// of the step squared, (pi / 4000)^2 = 6e-7, times what the kinks amount to, below 1.
constexpr int roundedLines = 4000;

Mass integratedRounded(std::vector<Vec2> corners, double radius, double density) {
    Vec2 about{0, 0};
    for (const Vec2& v : corners) about += v / static_cast<double>(corners.size());
    double low = 1e300, high = -1e300;
    for (Vec2& v : corners) {
        v -= about;
        low = std::min(low, v.y() - radius);
        high = std::max(high, v.y() + radius);
    }
    const double middle = (low + high) / 2, reach = (high - low) / 2;
    Moments moments;
    for (int i = 0; i < roundedLines; ++i) {
        const double angle = (i + 0.5) / roundedLines * std::numbers::pi - std::numbers::pi / 2;
        const double y = middle + reach * std::sin(angle);
        moments.hold(roundedChordAt(corners, radius, y), y, reach * std::cos(angle) * std::numbers::pi / roundedLines);
    }
    return massFrom(moments, about, density);
}

// Corners on an ellipse no flatter than 1 : 5, at least 3 % of a turn apart, turned and shifted.
Polygon someConvexPolygon(Random& random) {
    const int count = random.integer(3, random.integer(0, 3) == 0 ? 64 : 8);
    const double flatness = random.uniform(0.2, 1);
    const double size = std::exp(random.uniform(-3, 3));
    const Rot turn = Rot::fromAngle(random.uniform(-3, 3));
    const Vec2 shift(random.uniform(-9, 9) * size, random.uniform(-9, 9) * size);
    Polygon polygon;
    for (int i = 0; i < count; ++i) {
        const double angle = (i + random.uniform(0, 0.7)) * 2 * std::numbers::pi / count;
        const Vec2 corner(size * std::cos(angle), flatness * size * std::sin(angle));
        polygon.vertices.push_back(turn * corner + shift);
    }
    return polygon;
}

struct Difference {
    double mass = 0, center = 0, inertia = 0;
};

// Relative to the mass, to the radius of gyration, and to the inertia.
Difference largest(const Difference& so, const Mass& a, const Mass& b) {
    return {std::max(so.mass, std::fabs(a.mass - b.mass) / b.mass),
            std::max(so.center, (a.center - b.center).norm() / std::sqrt(b.inertia / b.mass)),
            std::max(so.inertia, std::fabs(a.inertia - b.inertia) / b.inertia)};
}

}  // namespace

TEST_CASE("mass properties of random polygons match numerical integration", "[shapes][mass]") {
    Random random(23);
    Difference worst;
    for (int round = 0; round < 5000; ++round) {
        const Polygon polygon = someConvexPolygon(random);
        const double density = random.uniform(0.1, 10);
        worst = largest(worst, massOf(polygon, density), integrated(polygon, density));
    }
    // A slim triangle has about 1/100 of the area and inertia of the square that its rounding errors scale with, and
    // some 30 roundings of 1.1e-16 each go into a sum.
    CHECK(worst.mass < 100 * 30 * 1.1e-16);
    CHECK(worst.center < 100 * 30 * 1.1e-16);
    CHECK(worst.inertia < 100 * 30 * 1.1e-16);
}

TEST_CASE("mass properties of random circles match numerical integration", "[shapes][mass]") {
    Random random(29);
    Difference worst;
    for (int round = 0; round < 100; ++round) {
        const Circle circle{.radius = std::exp(random.uniform(-5, 5)),
                            .center = {random.uniform(-9, 9), random.uniform(-9, 9)}};
        const double density = random.uniform(0.1, 10);
        worst = largest(worst, massOf(circle, density), integrated(circle, density));
    }
    // 64 roundings of 1.1e-16, and the centre is simply the same.
    CHECK(worst.mass < 64 * 1.1e-16);
    CHECK(worst.center < 64 * 1.1e-16);
    CHECK(worst.inertia < 64 * 1.1e-16);
}

TEST_CASE("mass properties of random rounded polygons and capsules match numerical integration", "[shapes][mass]") {
    Random random(47);
    Difference worst;
    for (int round = 0; round < 300; ++round) {
        Polygon polygon = someConvexPolygon(random);
        const double size = (polygon.vertices[1] - polygon.vertices[0]).norm();
        polygon.radius = size * std::exp(random.uniform(-4, 2));
        worst = largest(worst, massOf(polygon, 2), integratedRounded(polygon.vertices, polygon.radius, 2));
        const Capsule capsule{polygon.vertices[0], polygon.vertices[1], polygon.radius};
        const std::vector<Vec2> ends{capsule.start, capsule.end};
        worst = largest(worst, massOf(capsule, 2), integratedRounded(ends, capsule.radius, 2));
    }
    CHECK(worst.mass < 6e-7);
    CHECK(worst.center < 6e-7);
    CHECK(worst.inertia < 6e-7);
}

TEST_CASE("a polygon of no radius, and one of a radius of 1e-9, have the same mass to 1e-8", "[shapes][mass]") {
    Polygon box = boxPolygon({1, 0.5}, {3, 4});
    const Mass sharp = massOf(box, 1);
    box.radius = 1e-9;
    const Mass rounded = massOf(box, 1);
    CHECK(std::fabs(rounded.mass - sharp.mass) < 1e-8);
    CHECK((rounded.center - sharp.center).norm() < 1e-15 * 10);
    CHECK(std::fabs(rounded.inertia - sharp.inertia) < 1e-8);
}

TEST_CASE("a rounded square of 2 m x 2 m and 1 m radius has 4 + 8 + pi square metres around its middle",
          "[shapes][mass]") {
    Polygon square = boxPolygon({1, 1}, {5, -2});
    square.radius = 1;
    const Mass mass = massOf(square, 1);
    CHECK(std::fabs(mass.mass - (12 + std::numbers::pi)) < 1e-14 * 16);
    CHECK((mass.center - Vec2(5, -2)).norm() < 1e-14);
}

TEST_CASE("a capsule has its centre in the middle, to the last bit", "[shapes][mass]") {
    CHECK(massOf(Capsule{{1, 2}, {3, 8}, 0.5}, 3).center == Vec2(2, 5));
}

TEST_CASE("a 2 m x 1 m box of 3 kg/m^2 has 6 kg and 2.5 kg m^2", "[shapes][mass]") {
    // m (w^2 + h^2) / 12, with w 2 m and h 1 m.
    const Mass mass = massOf(boxPolygon({1, 0.5}, {7, -3}), 3);
    CHECK(mass.mass == 6);
    CHECK(mass.center == Vec2(7, -3));
    CHECK(std::fabs(mass.inertia - 2.5) < 1e-15 * 10);
}

TEST_CASE("a polygon 1,000 km from the origin keeps every digit of its mass and inertia", "[shapes][mass]") {
    Random random(31);
    const Vec2 far(1e6, -1e6);
    double worst = 0;
    for (int round = 0; round < 200; ++round) {
        Polygon near = someConvexPolygon(random);
        Polygon shifted = near;
        for (std::size_t i = 0; i < near.vertices.size(); ++i) {
            // Multiples of 2^-20 of at most 2^20: both places are exact.
            const Vec2 steps = near.vertices[i] * 0x1p20;
            near.vertices[i] = Vec2(std::round(steps.x()), std::round(steps.y())) * 0x1p-20;
            shifted.vertices[i] = near.vertices[i] + far;
        }
        const Mass a = massOf(near, 1);
        const Mass b = massOf(shifted, 1);
        worst = std::max({worst, std::fabs(a.mass - b.mass), std::fabs(a.inertia - b.inertia)});
        // The centre itself is a double next to 1e6.
        CHECK((a.center + far - b.center).norm() < 2e-10);
    }
    CHECK(worst == 0);
}

TEST_CASE("a segment or a chain has no mass", "[shapes][mass]") {
    CHECK(massOf(Chain{{{1, 2}, {3, 4}, {5, 0}}}, 5).mass == 0);
    const Mass mass = massOf(Segment{{1, 2}, {3, 4}}, 5);
    CHECK(mass.mass == 0);
    CHECK(mass.inertia == 0);
    CHECK(mass.center == Vec2(2, 3));
}

TEST_CASE("a polygon cut in two combines to itself", "[shapes][mass]") {
    Random random(37);
    Difference worst;
    for (int round = 0; round < 1000; ++round) {
        const Polygon whole = someConvexPolygon(random);
        if (whole.vertices.size() < 4) continue;
        const auto cut = whole.vertices.begin() + 2;
        Polygon first{{whole.vertices.begin(), cut + 1}};
        Polygon second{{cut, whole.vertices.end()}};
        second.vertices.push_back(whole.vertices.front());
        const std::array parts = {massOf(first, 2), massOf(second, 2)};
        worst = largest(worst, combine(parts), massOf(whole, 2));
    }
    // As for whole polygons, above.
    CHECK(worst.mass < 100 * 30 * 1.1e-16);
    CHECK(worst.center < 100 * 30 * 1.1e-16);
    CHECK(worst.inertia < 100 * 30 * 1.1e-16);
}

TEST_CASE("two discs of 1 kg on a massless rod of 2 m have 2 kg and 3 kg m^2", "[shapes][mass]") {
    // Each disc of 1 m radius has 1/2 kg m^2, and lies 1 m from the common centre.
    const Mass rod = massOf(Segment{{10, 0}, {12, 0}}, 9);
    const std::array parts = {rod, Mass{1, {10, 0}, 0.5}, Mass{1, {12, 0}, 0.5}};
    const Mass all = combine(parts);
    CHECK(all.mass == 2);
    CHECK(all.center == Vec2(11, 0));
    CHECK(all.inertia == 3);
}

TEST_CASE("nothing combines to nothing, and one part to itself", "[shapes][mass]") {
    CHECK(combine({}).mass == 0);
    CHECK(combine({}).inertia == 0);
    const std::array one = {Mass{2, {3, 4}, 5}};
    CHECK(combine(one).mass == 2);
    CHECK(combine(one).center == Vec2(3, 4));
    CHECK(combine(one).inertia == 5);
    const std::array massless = {Mass{0, {3, 4}, 0}, Mass{0, {5, 6}, 0}};
    CHECK(combine(massless).mass == 0);
    CHECK(combine(massless).inertia == 0);
}
