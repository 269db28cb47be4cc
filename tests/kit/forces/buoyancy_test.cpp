// SPDX-License-Identifier: MIT
#include <plumb/forces/buoyancy.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

#include <plumb/forces/drag.h>
#include <plumb/math/random.h>
#include <plumb/math/rot.h>

#include "cases.h"
#include "catch.h"

using namespace plumb;

namespace {

using Points = std::vector<Vec2>;

const Points square{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
const Fluid water{};

Points placed(const Points& points, const Vec2& shift, double angle) {
    const Rot turn = Rot::fromAngle(angle);
    Points result;
    for (const Vec2& point : points) result.push_back(turn * point + shift);
    return result;
}

/// Sutherland and Hodgman's: the polygon that is left below the surface, corner by corner.
Points clipped(const Points& polygon, const Fluid& fluid) {
    const Vec2 down = fluid.gravity.normalized();
    Points left;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        const double da = down.dot(a - fluid.surface), db = down.dot(b - fluid.surface);
        if (da >= 0) left.push_back(a);
        if ((da > 0 && db < 0) || (da < 0 && db > 0)) left.push_back(a + (b - a) * (da / (da - db)));
    }
    return left;
}

/// The fan of triangles from the first corner.
Submerged fanOf(const Points& polygon, const Fluid& fluid) {
    double area = 0;
    Vec2 moment(0, 0);
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        const Vec2 a = polygon[0], b = polygon[i - 1], c = polygon[i];
        const Vec2 u = b - a, v = c - a;
        const double part = cross(u, v) / 2;
        area += part;
        moment += part * (a + b + c) / 3;
    }
    const Vec2 centroid = area > 0 ? Vec2(moment / area) : Vec2(0, 0);
    return {area, centroid, fluid.gravity.normalized().dot(centroid - fluid.surface)};
}

/// An outline of straight pieces within a rounded one: each corner's turn in many steps.
Points polygonised(const Points& corners, double radius, int pieces) {
    Points points;
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 in = n > 1 ? Vec2(corners[i] - corners[(i + n - 1) % n]) : Vec2(1, 0);
        const Vec2 out = n > 1 ? Vec2(corners[(i + 1) % n] - corners[i]) : Vec2(1, 0);
        const double first = std::atan2(-in.x(), in.y());
        double sweep = std::atan2(-out.x(), out.y()) - first;
        if (sweep <= 0) sweep += 2 * M_PI;
        for (int k = 0; k <= pieces; ++k) {
            const double angle = first + sweep * k / pieces;
            points.push_back(corners[i] + radius * Vec2(std::cos(angle), std::sin(angle)));
        }
    }
    return points;
}

/// A star of 3 to 20 corners around the origin, mostly concave.
Points randomStar(Random& random, double size) {
    Points points;
    const int corners = random.integer(3, 20);
    for (int i = 0; i < corners; ++i)
        points.push_back(Rot::fromAngle(2 * M_PI * i / corners) * Vec2(size * random.uniform(0.1, 1), 0));
    return points;
}

Points randomRounded(Random& random, double size) {
    const double w = size * random.uniform(0.1, 1), h = size * random.uniform(0.1, 1);
    switch (random.integer(0, 3)) {
        case 0: return {{w, h}};
        case 1: return {{-w, 0}, {w, h}};
        case 2: return {{-w, -h}, {w, -h}, {0, h}};
        default: return {{-w, -h}, {w, -h}, {w, h}, {-w, h}};
    }
}

Fluid randomFluid(Random& random) {
    const Vec2 surface{random.uniform(-5, 5), random.uniform(-5, 5)};
    const Rot turn = Rot::fromAngle(random.uniform(-3, 3));
    return {.surface = surface, .gravity = turn * Vec2(0, -random.uniform(1, 20))};
}

/// Areas and their moments over the size's square and cube, so that a centroid far off a sliver counts as little as
/// the sliver does.
double difference(const Submerged& a, const Submerged& b, const Vec2& center, double size) {
    const double area = std::fabs(a.area - b.area) / (size * size);
    const Vec2 momentA = a.area * (a.centroid - center), momentB = b.area * (b.centroid - center);
    return std::max(area, (momentA - momentB).norm() / (size * size * size));
}

}  // namespace

TEST_CASE("areas under water are those of the polygon that is left, in 100,000 places", "[forces][law]") {
    Random random(51);
    double worst = 0;
    int part = 0;
    const int places = test::cases(100'000);
    for (int i = 0; i < places; ++i) {
        const double size = std::exp(random.uniform(-3, 3));
        const Fluid fluid = randomFluid(random);
        const Vec2 center = fluid.surface + size * Vec2{random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5)};
        const double angle = random.uniform(-3, 3);
        const Points star = placed(randomStar(random, size), center, angle);
        const Submerged found = submergedPart(star, 0, fluid), left = fanOf(clipped(star, fluid), fluid);
        worst = std::max(worst, difference(found, left, center, size));
        if (found.area > 0)
            worst = std::max(worst, std::fabs(found.depth - left.depth) * left.area / (size * size * size));
        const Points reversed(star.rbegin(), star.rend());
        worst = std::max(worst, std::fabs(submergedPart(reversed, 0, fluid).area - found.area) / (size * size));
        part += left.area > 0 && left.area < 0.999 * fanOf(star, fluid).area;
    }
    std::cout << "forces: areas under water are off by at most " << worst << " of the size (" << part << " of "
              << places << " cut)\n";
    // Some hundred roundings of places up to 8 m, of sizes from 0.05 m on.
    CHECK(worst < 100 * 1.1e-16 * 8 / 0.05);
    CHECK(part > places / 4);
}

TEST_CASE("rounded areas under water are those of 400 pieces a corner, in 10,000 places", "[forces][law]") {
    Random random(52);
    double worst = 0;
    const int pieces = 400, places = test::cases(10'000);
    for (int i = 0; i < places; ++i) {
        const double size = std::exp(random.uniform(-3, 3)), radius = size * random.uniform(0.05, 1);
        const Fluid fluid = randomFluid(random);
        const Vec2 center = fluid.surface + 2 * size * Vec2{random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5)};
        const double angle = random.uniform(-3, 3);
        const Points corners = placed(randomRounded(random, size), center, angle);
        const Submerged found = submergedPart(corners, radius, fluid);
        const Submerged left = fanOf(clipped(polygonised(corners, radius, pieces), fluid), fluid);
        worst = std::max(worst, difference(found, left, center, 2 * size));
    }
    std::cout << "forces: rounded areas under water differ from those of pieces by at most " << worst
              << " of the size (" << places << " places)\n";
    // A whole turn lacks pi r^2 (2 pi / 400)^2 / 6 = 1.3e-4 r^2 in each 400 pieces; r up to half of 2 size, with a
    // lever of as much again.
    CHECK(worst < 1.3e-4 / 4 * 2);
}

TEST_CASE("a circle's part under water is a circular segment", "[forces][law]") {
    // Area r^2 (t - sin t) / 2, its centroid 4 r sin^3(t / 2) / (3 (t - sin t)) from the centre; t the angle it spans.
    for (const double t : {0.1, 1.0, 2.0, 3.141592653589793, 4.0, 6.0}) {
        const double r = 3;
        const Vec2 center(7, r * std::cos(t / 2));  // above the surface by that
        const Submerged part = submergedPart(Points{center}, r, water);
        CHECK(std::fabs(part.area - r * r * (t - std::sin(t)) / 2) < 1e-14);
        const double below = 4 * r * std::pow(std::sin(t / 2), 3) / (3 * (t - std::sin(t)));
        // Moments are sums of numbers up to r^3 = 27, some ten times rounded.
        CHECK(std::fabs(part.depth - below + center.y()) < 10 * 27 * 1.1e-16 / part.area);
        CHECK(std::fabs(part.centroid.x() - 7) < 10 * 27 * 1.1e-16 / part.area);
    }
}

TEST_CASE("what is a million metres down is whole, to the last places", "[forces]") {
    const Submerged circle = submergedPart(Points{{3, -1e6}}, 1, water);
    CHECK(std::fabs(circle.area - M_PI) < 1e-15);
    CHECK(circle.depth == 1e6);
    const Submerged box = submergedPart(placed(square, {-1e6, -1e6}, 0), 0, water);
    CHECK(std::fabs(box.area - 1) < 1e-9);  // its corners are rounded to 1e-10
    CHECK((box.centroid - Vec2(-1e6, -1e6)).norm() < 1e-9);
}

TEST_CASE("a box of half the density of water floats half sunk", "[forces][law]") {
    // Let go above the water and held back by it, it comes to rest where 500 kg/m^2 push 500 kg/m^2 of water away.
    const double mass = 500;
    double y = 2, speed = 0;
    const double h = 1e-3;
    for (int i = 0; i < 60'000; ++i) {
        const Submerged part = submergedPart(placed(square, {0, y}, 0), 0, water);
        const double drag = dragForce({.linear = 2000 * part.area}, {0, speed}).y();
        speed += h * (buoyancyForce(water, part).y() + drag - mass * 9.81) / mass;
        y += h * speed;
    }
    CHECK(std::fabs(y) < 1e-12);
    CHECK(std::fabs(speed) < 1e-12);
}

// Gilbert, "How things float", Am. Math. Monthly 98 (1991): a square bar floats upright below a relative density of
// (3 - sqrt(3)) / 6 = 0.2113 and on its edge from 9/32 = 0.28125 on, to 23/32.
TEST_CASE("a square bar floats upright at a density of 0.2, and on its edge at 0.3", "[forces][law]") {
    const auto angleOf = [](double density) {
        const double mass = 1000 * density, inertia = mass / 6, h = 2e-3;
        double y = 0, speed = 0, angle = 0.1, turning = 0;
        for (int i = 0; i < 200'000; ++i) {
            const Submerged part = submergedPart(placed(square, {0, y}, angle), 0, water);
            const Vec2 force = buoyancyForce(water, part);
            speed += h * (force.y() / mass - 9.81 - 2 * speed);
            turning += h * (cross(part.centroid - Vec2(0, y), force) / inertia - turning);
            y += h * speed;
            angle += h * turning;
        }
        return angle * 180 / M_PI;
    };
    CHECK(std::fabs(angleOf(0.2)) < 1e-6);
    CHECK(std::fabs(angleOf(0.3) - 45) < 1e-6);
}

TEST_CASE("nothing is borne above the water, without gravity, or without an outline", "[forces]") {
    CHECK(submergedPart(placed(square, {0, 0.5}, 0), 0, water).area == 0);
    CHECK(submergedPart(Points{{0, 1}}, 1, water).area == 0);
    CHECK(submergedPart(square, 0, {.gravity = {0, 0}}).area == 0);
    CHECK(submergedPart({}, 1, water).area == 0);
    CHECK(submergedPart(Points{{0, -1}}, 0, water).area == 0);
    CHECK(submergedPart(Points{{0, -1}, {1, -1}}, 0, water).area == 0);
    CHECK(buoyancyForce(water, Submerged{}) == Vec2(0, 0));
    CHECK(potentialEnergy(water, Submerged{}) == 0);
    CHECK(submergedPart(square, 0, {.surface = {0, 1e200}}).area <= 1 + 1e-15);
}

TEST_CASE("outlines and fluids that nothing has are refused by name", "[forces][errors]") {
    const Points reversed(square.rbegin(), square.rend());
    CHECK_THROWS_WITH(submergedPart(reversed, 0.1, water),
                      "submergedPart: corners: with a radius, they must be convex and counter-clockwise");
    CHECK_THROWS_WITH(submergedPart(Points{{0, 0}, {0, 0}}, 0.1, water),
                      "submergedPart: corners: with a radius, they must be convex and counter-clockwise");
    CHECK_THROWS_WITH(submergedPart(square, -1, water), "submergedPart: radius: -1 is negative");
    CHECK_THROWS_WITH(submergedPart(Points{{0, std::nan("")}}, 1, water),
                      "submergedPart: corners: (0, nan) is not finite");
    CHECK_THROWS_WITH(submergedPart(square, 0, {.density = -1}), "Fluid.density: -1 is negative");
    CHECK_THROWS_WITH(buoyancyForce({.gravity = {0, std::nan("")}}, Submerged{}),
                      "Fluid.gravity: (0, nan) is not finite");
}
