// SPDX-License-Identifier: MIT
// Splines against the pyramid that defines them.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

#include <plumb/math/random.h>
#include <plumb/math/rot.h>
#include <plumb/movers/path_shape.h>

#include "cases.h"
#include "catch.h"
#include "kit/movers/long_points.h"
#include "numbers.h"

namespace {

using namespace plumb;
using namespace plumb::test;

/// The curve between the second and the third of four points, by the pyramid of Barry and Goldman ("A recursive
/// evaluation algorithm for a class of Catmull-Rom splines", 1988), at a part of its time, in long double.
LongPoint pyramid(const Curve& points, Real part) {
    std::array<Real, 4> t{};
    std::array<LongPoint, 4> p;
    for (std::size_t i = 0; i < 4; ++i) p[i] = real(points[i]);
    for (std::size_t i = 1; i < 4; ++i) t[i] = t[i - 1] + std::sqrt(distance(p[i - 1], p[i]));
    const Real time = t[1] + part * (t[2] - t[1]);
    const auto mix = [&](LongPoint a, LongPoint b, std::size_t from, std::size_t to) {
        return (t[to] - time) / (t[to] - t[from]) * a + (time - t[from]) / (t[to] - t[from]) * b;
    };
    const LongPoint a = mix(p[0], p[1], 0, 1), b = mix(p[1], p[2], 1, 2), c = mix(p[2], p[3], 2, 3);
    return mix(mix(a, b, 0, 2), mix(b, c, 1, 3), 1, 2);
}

/// LongPoint i of a ring, or of a line that its ends' neighbours are mirrored at.
Vec2 pointOf(const std::vector<Vec2>& points, int i, bool closed) {
    const int count = static_cast<int>(points.size());
    const auto at = [&](int k) { return points[static_cast<std::size_t>(k)]; };
    if (closed) return at((i + count) % count);
    return i < 0 ? Vec2(2 * at(0) - at(1)) : i >= count ? Vec2(2 * at(count - 1) - at(count - 2)) : at(i);
}

}  // namespace

TEST_CASE("a step along 200 random splines goes as far as it says, to a tangent's error, and never faster",
          "[movers]") {
    Random random(6);
    double worst = 0;
    for (int run = 0; run < cases(2000); ++run) {
        std::vector<Vec2> points;
        for (int i = random.integer(3, 12); i > 0; --i)
            points.push_back({random.uniform(-50, 50), random.uniform(-50, 50)});
        const MotionPath path = splineThrough(points, run % 2 == 0);
        const double step = 1e-4 * path.length();
        for (int i = 0; i < 20; ++i) {
            const double s = random.uniform(0, path.length() - step);
            const PathPlace a = path.at(s), b = path.at(s + step);
            const double went = (b.position - a.position).norm();
            // The chord of an arc is never longer; twice the error of a place, 1e-11 of a curve's size, at most 500 m.
            REQUIRE(went <= step + 2e-11 * 500);
            REQUIRE(std::fabs(a.tangent.norm() - 1) < 1e-15);
            // Shorter by (turn)^2 / 24, turn the angle of the two tangents, for a bend that is even; 1/8 if it is not.
            const double turn = (b.tangent - a.tangent).norm();
            REQUIRE(went >= step * (1 - turn * turn / 8) - 2e-11 * 500);
            worst = std::max(worst, went / step - 1);
        }
    }
    std::cout << "steps along splines: longer than told by at most " << worst << " of themselves\n";
}

TEST_CASE("1,000 random splines, open and closed, are the pyramid of Barry and Goldman, and smooth at their points",
          "[movers]") {
    Random random(7);
    double worst = 0, worstBend = 0;
    for (int run = 0; run < cases(1000); ++run) {
        std::vector<Vec2> points;
        const int count = random.integer(4, 9);
        const bool closed = run % 2 == 0, round = run % 4 < 2;
        for (int i = 0; i < count; ++i) {
            const Vec2 anywhere{random.uniform(-5, 5), random.uniform(-5, 5)};
            const Vec2 spoke(random.uniform(3, 5), 0);
            points.push_back(round ? Vec2(Rot::fromAngle(2 * pi * i / count) * spoke) : anywhere);
        }
        const MotionPath path = splineThrough(points, closed);
        REQUIRE(path.closed() == closed);
        Real start = 0, slack = 1e-10;
        const int curves = closed ? count : count - 1, edges = 500;
        for (int i = 0; i < curves; ++i) {
            const Curve four{pointOf(points, i - 1, closed), pointOf(points, i, closed), pointOf(points, i + 1, closed),
                             pointOf(points, closed ? (i + 2) % count : i + 2, closed)};
            std::vector<Real> fine{0}, coarse{0};
            for (int k = 1; k <= 2 * edges; ++k)
                fine.push_back(fine.back() +
                               distance(pyramid(four, (k - 1) / (2.0L * edges)), pyramid(four, k / (2.0L * edges))));
            for (int k = 1; k <= edges; ++k)
                coarse.push_back(coarse.back() + distance(pyramid(four, static_cast<Real>(k - 1) / edges),
                                                          pyramid(four, static_cast<Real>(k) / edges)));
            const auto lengthTo = [&](std::size_t k) { return fine[2 * k] + (fine[2 * k] - coarse[k]) / 3; };
            // What polylines leave: all of their gap, to be safe where a curve is sharp.
            slack += fine.back() - coarse.back();
            for (const std::size_t k : {std::size_t{0}, std::size_t{123}, std::size_t{250}, std::size_t{499}}) {
                const PathPlace place = path.at(static_cast<double>(start + lengthTo(k)));
                const Real off = distance(real(place.position), pyramid(four, static_cast<Real>(k) / edges));
                CAPTURE(run, i, k);
                REQUIRE(off <= slack);
                worst = std::max(worst, static_cast<double>(off));
            }
            start += lengthTo(static_cast<std::size_t>(edges));
            if (!round || (i + 1 == curves && !closed)) continue;
            const double along = std::fmod(static_cast<double>(start), path.length());
            // Past the slack on both sides, so that a kink would be between.
            const double beside = 2 * static_cast<double>(slack);
            const double before = along - beside < 0 ? along - beside + path.length() : along - beside;
            const double kink = (path.at(along + beside).tangent - path.at(before).tangent).norm();
            worstBend = std::max(worstBend, kink / (2 * beside));
            // Points 3 to 5 m from the middle leave no bend as sharp as 2 cm; a kink would be of any size.
            REQUIRE(kink < 50 * 2 * beside);
        }
        REQUIRE(std::fabs(path.length() - static_cast<double>(start)) <= static_cast<double>(slack));
    }
    std::cout << "splines against the pyramid: at most " << worst << " m off; sharpest bend at a point " << worstBend
              << " 1/m\n";
}
