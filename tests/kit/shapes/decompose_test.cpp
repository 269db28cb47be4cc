// SPDX-License-Identifier: MIT
#include <plumb/shapes/decompose.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <plumb/math/random.h>
#include <plumb/shapes/mass.h>
#include <plumb/space/shape_def.h>

#include "cases.h"
#include "catch.h"

namespace {

using namespace plumb;
using namespace plumb::test;
using Points = std::vector<Vec2>;

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Mass, centre and inertia of what an outline encloses, at density 1, by Green's theorem over its edges; signed.
Mass massWithin(const Points& outline) {
    const Vec2 o = outline.front();
    double area = 0, second = 0;
    Vec2 first{0, 0};
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 p = outline[i] - o, q = outline[(i + 1) % outline.size()] - o;
        const double c = p.x() * q.y() - q.x() * p.y();
        area += c / 2;
        first += c * (p + q) / 6;
        second += c * (p.dot(p) + p.dot(q) + q.dot(q)) / 12;
    }
    const Vec2 center = first / area;
    return {area, o + center, second - area * center.dot(center)};
}

/// How often an outline goes around a point; by crossings of the ray to the right of it.
int windingAround(const Points& outline, const Vec2& p) {
    int winding = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
        if (a.y() <= p.y() && b.y() > p.y() && turn(a, b, p) > 0) ++winding;
        if (a.y() > p.y() && b.y() <= p.y() && turn(a, b, p) < 0) --winding;
    }
    return winding;
}

double distanceTo(const Points& outline, const Vec2& p) {
    double least = 1e300;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 &a = outline[i], edge = outline[(i + 1) % outline.size()] - a;
        const double part = std::clamp((p - a).dot(edge) / edge.dot(edge), 0.0, 1.0);
        least = std::min(least, (p - a - part * edge).norm());
    }
    return least;
}

/// How deep a point is in a convex piece; negative outside.
double depthIn(const Polygon& piece, const Vec2& p) {
    double least = 1e300;
    for (std::size_t i = 0; i < piece.vertices.size(); ++i) {
        const Vec2 &a = piece.vertices[i], &b = piece.vertices[(i + 1) % piece.vertices.size()];
        least = std::min(least, turn(a, b, p) / (b - a).norm());
    }
    return least;
}

Vec2 at(double angle, double radius) {
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

Points star(Random& random) {
    Points points;
    const int count = random.integer(3, 40);
    for (int i = 0; i < count; ++i)
        points.push_back(at(2 * std::numbers::pi * (i + random.uniform(0, 0.8)) / count, random.uniform(0.2, 3)));
    return points;
}

/// Teeth whose feet lie in line.
Points comb(Random& random) {
    const int teeth = random.integer(1, 12);
    Points points{{0, 0}, {2.0 * teeth + 1, 0}};
    for (int i = teeth; i >= 0; --i) {
        const double height = random.uniform(1.5, 4);
        points.push_back({2.0 * i + 1, i == teeth ? height : 1});
        points.back().y() = height;
        points.push_back({2.0 * i, height});
        if (i == 0) break;
        points.push_back({2.0 * i, 1});
        points.push_back({2.0 * i - 1, 1});
    }
    return points;
}

Points spiral(Random& random) {
    const int count = random.integer(40, 60);
    const double turns = random.uniform(0.5, 3), wide = random.uniform(0.1, 0.6);
    Points points;
    for (int i = 0; i < count; ++i)
        points.push_back(at(2 * std::numbers::pi * turns * i / count, 1 + turns * i / count));
    for (int i = count - 1; i >= 0; --i)
        points.push_back(at(2 * std::numbers::pi * turns * i / count, 1 + turns * i / count + wide));
    return points;
}

bool cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

/// Points in any order; where two edges cross, what lies between is turned around: the outline grows shorter by it.
Points tangle(Random& random) {
    Points points;
    const int count = random.integer(4, 25);
    for (int i = 0; i < count; ++i) {
        const double x = random.uniform(-2, 2);
        points.push_back({x, random.uniform(-2, 2)});
    }
    const std::size_t n = points.size();
    for (bool crossed = true; crossed;) {
        crossed = false;
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = i + 2; j < n; ++j)
                if (cross(points[i], points[i + 1], points[j], points[(j + 1) % n])) {
                    std::reverse(points.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                 points.begin() + static_cast<std::ptrdiff_t>(j) + 1);
                    crossed = true;
                }
    }
    return points;
}

/// Points that say nothing new are put in, all is turned, shifted and sized, and half of it run the other way round.
Points disguised(Points points, Random& random) {
    Points result;
    for (std::size_t i = 0; i < points.size(); ++i) {
        result.push_back(points[i]);
        const int more = random.integer(0, 9);
        if (more == 0) result.push_back(points[i]);
        if (more == 1) result.push_back(0.5 * (points[i] + points[(i + 1) % points.size()]));
    }
    const double angle = random.integer(0, 2) ? random.uniform(-3, 3) : 0, size = std::exp(random.uniform(-5, 5));
    const double x = random.uniform(-9, 9);
    const Vec2 shift(x, random.uniform(-9, 9)), turnX = at(angle, size), turnY(-turnX.y(), turnX.x());
    for (Vec2& p : result) p = turnX * p.x() + turnY * p.y() + shift;
    if (random.integer(0, 1) == 0) std::reverse(result.begin(), result.end());
    const auto first = static_cast<std::ptrdiff_t>(random.integer(0, static_cast<int>(result.size()) - 1));
    std::rotate(result.begin(), result.begin() + first, result.end());
    return result;
}

/// Null when the pieces are right.
const char* faultOf(const Points& outline, const std::vector<Polygon>& pieces, Random& random) {
    Vec2 lower = outline[0], upper = outline[0];
    for (const Vec2& p : outline) {
        lower = lower.cwiseMin(p);
        upper = upper.cwiseMax(p);
    }
    const double extent = (upper - lower).norm(), number = lower.cwiseAbs().cwiseMax(upper.cwiseAbs()).maxCoeff();
    const double blur = 1e-13 * (extent + number);  // some hundred roundings of the coordinates
    std::vector<Mass> parts;
    for (const Polygon& piece : pieces) {
        validate(piece, "piece");
        parts.push_back(massOf(piece, 1));
        for (const Vec2& p : piece.vertices)
            if (std::find(outline.begin(), outline.end(), p) == outline.end()) return "a corner is not of the outline";
    }
    const Mass whole = massWithin(outline), together = combine(parts);
    if (std::fabs(together.mass - std::fabs(whole.mass)) > blur * extent) return "the areas do not add up";
    if ((together.center - whole.center).norm() > blur * extent * extent / std::fabs(whole.mass) * 3)
        return "the centre is not the whole's";
    if (std::fabs(together.inertia - std::fabs(whole.inertia)) > 10 * blur * extent * extent * extent)
        return "the inertia is not the whole's";
    for (int i = 0; i < 100; ++i) {
        const double x = random.uniform(lower.x(), upper.x());
        const Vec2 p(x, random.uniform(lower.y(), upper.y()));
        if (distanceTo(outline, p) < 10 * blur) continue;
        int touched = 0, within = 0;
        for (const Polygon& piece : pieces) {
            touched += depthIn(piece, p) > -blur;
            within += depthIn(piece, p) > blur;
        }
        const bool inside = windingAround(outline, p) != 0;
        if (inside && touched == 0) return "a point inside is in no piece";
        if (!inside && within > 0) return "a point outside is in a piece";
        if (within > 1) return "two pieces overlap";
    }
    return nullptr;
}

struct Taken {
    std::vector<Polygon> pieces;
    std::string complaint;
};

Taken takeApart(const Points& outline) {
    try {
        return {convexPieces(outline), ""};
    } catch (const std::invalid_argument& refused) {
        return {{}, refused.what()};
    }
}

std::string complaintAbout(const Points& outline) {
    return takeApart(outline).complaint;
}

}  // namespace

TEST_CASE("pieces of 8,000 random outlines cover them, and nothing else, without overlapping", "[shapes]") {
    struct Family {
        const char* name;
        Points (*make)(Random&);
    };
    for (const Family& family :
         {Family{"stars", star}, Family{"combs", comb}, Family{"spirals", spiral}, Family{"tangles", tangle}}) {
        Random random(77);
        int faults = 0, refused = 0;
        std::size_t pieceCount = 0, corners = 0;
        std::string first;
        for (int i = 0; i < allCases(2000); ++i) {
            const Points outline = disguised(family.make(random), random);
            corners += outline.size();
            const Taken taken = takeApart(outline);
            std::string fault = taken.complaint;
            refused += !fault.empty();
            pieceCount += taken.pieces.size();
            const char* wrong = fault.empty() ? faultOf(outline, taken.pieces, random) : nullptr;
            if (wrong) fault = wrong;
            if (!fault.empty() && faults++ == 0) first = "outline " + std::to_string(i) + ": " + fault;
        }
        INFO(family.name << ": " << corners << " corners, " << pieceCount << " pieces, " << refused << " refused; "
                         << faults << " faults, the first: " << first);
        CHECK(faults == 0);
        CHECK(2 * pieceCount < corners);
    }
}

TEST_CASE("20,000 outlines on a coarse grid, most of them at fault, are taken apart rightly or refused", "[shapes]") {
    Random random(99);
    int taken = 0, faults = 0;
    std::string first;
    for (int i = 0; i < 20'000; ++i) {
        const int cells = random.integer(1, 6), count = random.integer(3, 9);
        // As far out as a body may lie, a coarse grid of doubles is fine enough for it; and so small that squares
        // vanish.
        const double size = std::exp2(random.integer(0, 4) ? 0 : random.integer(-400, 40));
        Points outline;
        for (int k = 0; k < count; ++k) {
            const double x = random.integer(0, cells);
            outline.push_back(size * Vec2(x, random.integer(0, cells)));
        }
        auto [pieces, complaint] = takeApart(outline);
        if (!complaint.empty()) continue;
        ++taken;
        Points unit = outline;
        for (Vec2& p : unit) p /= size;
        for (Polygon& piece : pieces)
            for (Vec2& p : piece.vertices) p /= size;
        const char* fault = faultOf(unit, pieces, random);
        if (fault && faults++ == 0) first = "outline " + std::to_string(i) + ": " + fault;
    }
    INFO(faults << " faults, the first: " << first);
    CHECK(faults == 0);
    CHECK(taken > 2000);
}

TEST_CASE("a convex outline of 64 corners is one piece, one of 65 two", "[shapes]") {
    for (const int count : {3, 4, 64, 65}) {
        Points points;
        for (int i = 0; i < count; ++i) points.push_back(at(2 * std::numbers::pi * i / count, 2));
        CHECK(convexPieces(points).size() == (count > maxPolygonVertices ? 2 : 1));
        std::reverse(points.begin(), points.end());
        CHECK(convexPieces(points).size() == (count > maxPolygonVertices ? 2 : 1));
    }
}

TEST_CASE("an L is two pieces, a plus sign three, and a comb of five teeth six", "[shapes]") {
    CHECK(convexPieces(Points{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}).size() == 2);
    CHECK(convexPieces(
              Points{{1, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 2}, {2, 2}, {2, 3}, {1, 3}, {1, 2}, {0, 2}, {0, 1}, {1, 1}})
              .size() == 3);
    Points comb{{0, 0}, {9, 0}};
    for (int i = 4; i >= 0; --i)
        for (const Vec2& p : {Vec2(1, 1), Vec2(1, 3), Vec2(0, 3), Vec2(0, 1)}) comb.push_back(p + Vec2(2.0 * i, 0));
    CHECK(convexPieces(comb).size() == 6);
}

TEST_CASE("a ring of 3,000 points with a slit is taken apart, and its inertia is a ring's", "[shapes]") {
    Points points;
    constexpr int count = 1500;
    for (int i = 0; i <= count; ++i) points.push_back(at(6.2 * i / count, 2));
    for (int i = count; i >= 0; --i) points.push_back(at(6.2 * i / count, 1));
    std::vector<Mass> parts;
    for (const Polygon& piece : convexPieces(points)) parts.push_back(massOf(piece, 1));
    const double area = 6.2 / 2 * (4 - 1), secondMoment = 6.2 / 4 * (16 - 1);
    const Mass whole = combine(parts);
    // Chords lie inside of their arcs: 2 (1 - sin(h) / h) / 3 of the square of the step h less, to first order.
    CHECK(std::fabs(whole.mass / area - 1) < 1e-5);
    CHECK(std::fabs((whole.inertia + whole.mass * whole.center.squaredNorm()) / secondMoment - 1) < 1e-5);
}

TEST_CASE("outlines that no shape could have are refused, by the name of the point", "[shapes]") {
    const double nan = std::nan("");
    CHECK_THAT(complaintAbout({}), containsText("convexPieces.outline: 0 points are fewer than 3"));
    CHECK_THAT(complaintAbout({{0, 0}, {1, nan}, {0, 1}}),
               containsText("convexPieces.outline[1]: (1, nan) is not finite"));
    CHECK_THAT(complaintAbout({{0, 0}, {1, 0}, {1, 0}, {1, 1e-9}}), containsText("convexPieces.outline["));
    CHECK_THAT(complaintAbout({{0, 0}, {1, 0}, {2, 0}}), containsText("convexPieces.outline["));
    CHECK_THAT(complaintAbout({{3, 1}, {3, 1}, {3, 1}}), containsText("are fewer than 3"));
    CHECK_THAT(complaintAbout({{0, 0}, {2, 2}, {2, 0}, {0, 2}}), containsText("neither cross nor touch itself"));
    CHECK_THAT(complaintAbout({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}),
               containsText("neither cross nor touch itself"));
    CHECK_THAT(complaintAbout({{0, 0}, {4, 0}, {2, 2}, {4, 4}, {0, 4}, {2, 2}}),
               containsText("neither cross nor touch"));
    CHECK_THAT(complaintAbout({{0, 0}, {4, 0}, {4, 4}, {4, 1}, {0, 4}}),
               containsText("folds the outline straight back"));
    const Points needle{{0, 0}, {1, 0}, {1, 1}, {0.5, 1}, {0.5 + 1e-8, 9}, {0.5 - 1e-8, 1}, {0, 1}};
    CHECK_THAT(complaintAbout(needle), containsText("convexPieces.outline["));
}

TEST_CASE("outline() gives the shapes of one body, each of the same material", "[shapes][space]") {
    const std::vector<ShapeDef> shapes =
        plumb::outline({{0, 2}, {1, 2}, {1, 1}, {2, 1}, {2, 0}, {0, 0}}, {.density = 3, .friction = 0.25});
    CHECK(shapes.size() == 2);
    double mass = 0;
    for (const ShapeDef& shape : shapes) {
        CHECK(shape.material.friction == 0.25);
        mass += massOf(shape.shape, shape.material.density).mass;
    }
    CHECK(mass == 9);
    CHECK_THROWS_AS(plumb::outline({{0, 0}, {1, 0}}), std::invalid_argument);
}
