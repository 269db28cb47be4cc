// SPDX-License-Identifier: MIT
// Curves that are made of chains: bowls, hills and loops. Each vertex that a disc meets takes sin^2 of its turn from
// the disc's energy, and nothing else does.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <plumb/plumb.h>
#include "catch.h"
#include "kit/dynamics/chain_track.h"
#include "kit/usual_world.h"

using namespace plumb;
using namespace plumb::test;

namespace {

constexpr double ballRadius = 0.1;

Vec2 onCircle(double radius, double angle) {
    return radius * Vec2(std::cos(angle), std::sin(angle));
}

std::vector<Vec2> bowlLine(int segments, double radius) {
    std::vector<Vec2> line;
    for (int i = 0; i <= segments; ++i)
        line.push_back(onCircle(radius, std::numbers::pi * (static_cast<double>(i) / segments - 1)));
    return line;
}

/// Two hollows with a hill between them.
std::vector<Vec2> hillLine(int segments, double size) {
    std::vector<Vec2> line;
    for (int i = 0; i <= segments; ++i) {
        const double x = 1.8 * (2.0 * i / segments - 1);
        line.push_back(size * Vec2(x, 0.5 * (x * x * x * x / 4 - x * x / 2)));
    }
    return line;
}

/// A slope, a fillet, and three quarters of a circle that ends where its side falls straight down. Its lowest point is
/// at 0.
std::vector<Vec2> loopLine(int segments, double radius) {
    std::vector<Vec2> line;
    const double quarter = 0.25 * std::numbers::pi;
    const Vec2 fillet(-radius, 3 * radius), foot = fillet + onCircle(3 * radius, -3 * quarter);
    line.push_back(foot + 4 * radius * Vec2(-1, 1));
    for (int i = 0; i <= 1000; ++i) line.push_back(fillet + onCircle(3 * radius, quarter * (i / 1000.0 - 3)));
    for (int i = 0; i <= 3 * segments / 4; ++i)
        line.push_back(Vec2(0, radius) + onCircle(radius, quarter * (8.0 * i / segments - 2)));
    return line;
}

double energyAt(const Vec2& place, double speedSquared, double lowest) {
    return 0.5 * speedSquared + g * (place.y() - lowest);
}

struct Kept {
    double ball = 0, truth = 0;  ///< share of the energy after 10 s
    double most = 0;             ///< largest share at any time
};

/// A ball that starts at rest at this share of the path.
Kept keptOn(const std::vector<Vec2>& line, double share, double rate) {
    const TrackPath path = pathOver(line, ballRadius);
    const auto lower = [](const Vec2& a, const Vec2& b) { return a.y() < b.y(); };
    const double lowest = std::min_element(path.points.begin(), path.points.end(), lower)->y();
    TrackPoint start{static_cast<std::size_t>(share * static_cast<double>(path.points.size())), 0, 0};
    start.way = 0.5 * (path.points[start.edge + 1] - path.points[start.edge]).norm();
    const Vec2 from = placeOn(path, start);
    World world;
    world.add({.type = BodyType::Static, .shapes = {chain(line, {.friction = 0})}});
    const BodyId ball = world.add({.position = from, .shapes = {circle(ballRadius, Material{.friction = 0})}});
    const double all = energyAt(from, 0, lowest);
    Kept kept;
    for (int t = 0; t < 10 * rate; ++t) {
        world.step(1 / rate);
        const auto body = world.body(ball);
        kept.ball = energyAt(body.position(), body.velocity().squaredNorm(), lowest) / all;
        kept.most = std::max(kept.most, kept.ball);
    }
    const TrackPoint end = slide(path, start, g, 10);
    kept.truth = energyAt(placeOn(path, end), end.speed * end.speed, lowest) / all;
    return kept;
}

/// The share of its energy that a ball has after 10 s if it rolls in a bowl from rest.
double keptRolling(int segments, double radius, double rate) {
    World world;
    world.add({.type = BodyType::Static, .shapes = {chain(bowlLine(segments, radius), {.friction = 1})}});
    const double path = radius - 1.01 * ballRadius, angle = -0.5 * std::numbers::pi - 1;
    const Vec2 from = onCircle(path, angle);
    const BodyId ball = world.add({.position = from, .shapes = {circle(ballRadius, Material{.friction = 1})}});
    for (int t = 0; t < 10 * rate; ++t) world.step(1 / rate);
    const auto body = world.body(ball);
    const double spin = body.angularVelocity() * ballRadius;
    return energyAt(body.position(), body.velocity().squaredNorm() + 0.5 * spin * spin, -path) /
           energyAt(from, 0, -path);
}

/// Does a ball that starts at this height over the loop's lowest point, both for its centre, come over the top?
bool passesLoop(int segments, double radius, double height, double rate) {
    const TrackPath path = pathOver(loopLine(segments, radius), ballRadius);
    const Vec2 along = (path.points[1] - path.points[0]).normalized();
    const Vec2 from = path.points[0] + along * ((path.points[0].y() - ballRadius - height) / -along.y());
    World world;
    world.add({.type = BodyType::Static, .shapes = {chain(loopLine(segments, radius), {.friction = 0})}});
    const BodyId ball = world.add({.position = from, .shapes = {circle(ballRadius, Material{.friction = 0})}});
    for (int t = 0; t < 10 * rate; ++t) {
        world.step(1 / rate);
        const Vec2 at = (world.body(ball).position() - Vec2(0, radius)) / radius;
        const bool above = at.y() > 0 && at.norm()<1, onTrack = at.norm()> 0.99 - ballRadius / radius;
        if (above && !onTrack) return false;
        if (above && at.x() < -0.7) return true;
    }
    return false;
}

}  // namespace

TEST_CASE("a ball keeps the energy that a bowl of 30 to 10,000 segments leaves it", "[dynamics][chain][law][slow]") {
    for (const int segments : {30, 100, 1000, 4000, 10'000})
        for (const double radius : {1.0, 20.0})
            for (const double rate : {30.0, 60.0, 120.0}) {
                if (segments > 4000 && rate > 60) continue;
                const Kept kept = keptOn(bowlLine(segments, radius), 0.18, rate);
                CAPTURE(segments, radius, rate, kept.truth);
                CHECK(kept.ball == Approx(kept.truth).margin(0.01));
                CHECK(kept.most < 1 + 1e-4);
            }
}

TEST_CASE("a ball that slides over a hill of 100 to 10,000 segments keeps its energy", "[dynamics][chain][law][slow]") {
    for (const int segments : {100, 1000, 4000, 10'000})
        for (const double size : {1.0, 5.0})
            for (const double rate : {30.0, 60.0}) {
                const Kept kept = keptOn(hillLine(segments, size), 0.03, rate);
                CAPTURE(segments, size, rate, kept.truth);
                CHECK(kept.ball == Approx(kept.truth).margin(0.01));
                CHECK(kept.most < 1 + 1e-4);
            }
}

TEST_CASE("a ball passes a loop of 1,000 segments from 2.6 radii, and not from 2.3", "[dynamics][chain][law]") {
    for (const double radius : {1.0, 5.0})
        for (const double rate : {30.0, 60.0, 120.0}) {
            CAPTURE(radius, rate);
            CHECK(passesLoop(1000, radius, 2.6 * (radius - ballRadius), rate));
            CHECK_FALSE(passesLoop(1000, radius, 2.3 * (radius - ballRadius), rate));
        }
}

TEST_CASE("a ball that rolls in a bowl loses less the finer the bowl, and never gains",
          "[dynamics][chain][law][slow]") {
    for (const double radius : {1.0, 5.0})
        for (const double rate : {30.0, 60.0, 120.0}) {
            double coarser = 0;
            for (const int segments : {30, 100, 300, 1000, 3000, 10'000}) {
                const double kept = keptRolling(segments, radius, rate);
                CAPTURE(segments, radius, rate, kept, coarser);
                CHECK(kept > coarser);
                CHECK(kept < 1);
                coarser = kept;
            }
            CHECK(coarser > 0.99);
        }
}

TEST_CASE("a ball rolls down a chain of collinear segments as down one segment", "[dynamics][chain]") {
    const auto endOn = [](int segments) {
        std::vector<Vec2> line;
        for (int i = 0; i <= segments; ++i) line.push_back({20.0 * i / segments, -5.0 * i / segments});
        World world;
        world.add({.type = BodyType::Static, .shapes = {chain(line)}});
        const Vec2 up = Vec2(5, 20).normalized();
        const Vec2 from = Vec2(1, -0.25) + ballRadius * up;
        const BodyId ball = world.add({.position = from, .shapes = {circle(ballRadius)}});
        for (int t = 0; t < 60; ++t) world.step(1.0 / 60);
        return world.body(ball).position();
    };
    const Vec2 one = endOn(1);
    for (const int segments : {2, 10, 100, 1000}) CHECK((endOn(segments) - one).norm() < 1e-3);
}
