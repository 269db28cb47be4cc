// SPDX-License-Identifier: MIT
#include <plumb/steering/path.h>

#include <algorithm>
#include <iostream>
#include <limits>
#include <vector>

#include <plumb/steering/seek.h>

#include "cases.h"
#include "catch.h"
#include "kit/steering/agents.h"

using namespace plumb;
using namespace agents;

namespace {

using Points = std::vector<Vec2>;

/// Bends to either side, none sharper than the given radius, in pieces of a twentieth of it.
Points windingPath(Random& random, double bend, int pieces) {
    Points points{{0, 0}};
    double angle = random.uniform(-M_PI, M_PI), curvature = 0;
    for (int i = 0; i < pieces; ++i) {
        curvature = std::clamp(curvature + random.uniform(-0.2, 0.2) / bend, -1 / bend, 1 / bend);
        angle += curvature * bend / 20;
        points.push_back(points.back() + bend / 20 * Vec2(std::cos(angle), std::sin(angle)));
    }
    return points;
}

/// By looking at all of it.
double distanceToPath(const Points& points, const Vec2& p) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const Vec2 edge = points[i + 1] - points[i];
        const double t = std::clamp((p - points[i]).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
        least = std::min(least, (p - points[i] - t * edge).norm());
    }
    return least;
}

}  // namespace

TEST_CASE("who follows 1,000 winding paths keeps within their radius, and comes to their end", "[steering]") {
    Random random(85);
    double worst = 0;
    int unfinished = 0, back = 0;
    const int paths = test::cases(1'000);
    for (int i = 0; i < paths; ++i) {
        // Bends that it can take, looks ahead from which followPath promises a radius.
        Agent agent = randomAgent(random);
        const double v = agent.maxSpeed, response = 2 * v * agent.responseTime;
        const double bend = std::max(2 * v * v / agent.maxAcceleration, 2 * response) * random.uniform(1, 3);
        const double ahead = random.uniform(std::max(response, 0.1 * bend), bend / 2);
        const double radius = ahead * ahead / (2 * bend);
        const Points points = windingPath(random, bend, 100);
        const Path path{points};
        agent.position = points[0];
        agent.velocity = v * (points[1] - points[0]).normalized();
        double progress = 0;
        const double time = 1.5 * lengthOf(path) / v + 10 * slowingDistanceOf(agent) / v;
        for (int k = 0; k * dt < time; ++k) {
            const PathStep step = followPath(agent, path, progress, ahead);
            back += step.progress < progress;
            progress = step.progress;
            agent = moved(agent, step.acceleration, dt);
            if (k % 10 == 0) worst = std::max(worst, distanceToPath(points, agent.position) / radius);
        }
        unfinished += (agent.position - points.back()).norm() > 1e-3 * bend;
    }
    std::cout << "steering: who follows a path leaves it by at most " << worst << " of the radius that was to hold ("
              << paths << " paths)\n";
    CHECK(worst < 1);
    CHECK(unfinished == 0);
    CHECK(back == 0);
}

TEST_CASE("a path that crosses itself is walked to its end, and a ring round and round", "[steering]") {
    // A figure of eight, two rings that touch in the middle.
    Points eight;
    for (int i = 0; i <= 200; ++i) {
        const double angle = 4 * M_PI * i / 200;
        eight.push_back(i <= 100 ? Vec2(5 * std::sin(angle), 5 - 5 * std::cos(angle))
                                 : Vec2(5 * std::sin(angle), 5 * std::cos(angle) - 5));
    }
    const auto walked = [](const Path& path, double seconds) {
        Agent agent{.velocity = {3, 0}, .maxSpeed = 3, .maxAcceleration = 10};
        double progress = 0, worst = 0;
        const Points points(path.points.begin(), path.points.end());
        for (int i = 0; i < seconds * 60; ++i) {
            const PathStep step = followPath(agent, path, progress, 1);
            progress = step.progress;
            agent = moved(agent, step.acceleration, dt);
            worst = std::max(worst, distanceToPath(points, agent.position));
        }
        CHECK(worst < 0.1);  // 1^2 / (2 * 5)
        return progress;
    };
    CHECK(std::fabs(walked({eight}, 40) - 20 * M_PI) < 0.1);  // 63 m at 3 m/s, and an arrival
    eight.pop_back();
    const double rounds = walked({.points = eight, .closed = true}, 60) / (20 * M_PI);
    CHECK(rounds > 2.7);  // 180 m, of which little is lost in the bends
    CHECK(rounds < 2.9);
}

TEST_CASE("along a square of 4 m the point 6 m on is in the middle of the second side", "[steering]") {
    const Points square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    const Path open{square}, ring{.points = square, .closed = true};
    CHECK(lengthOf(open) == 12);
    CHECK(lengthOf(ring) == 16);
    CHECK(pointOn(open, 6) == Vec2(4, 2));
    CHECK(pointOn(ring, 15) == Vec2(0, 1));
    CHECK(pointOn(ring, 1606) == Vec2(4, 2));
    CHECK(pointOn(open, 100) == Vec2(0, 4));
    CHECK(pointOn(open, -1) == Vec2(0, 0));
}

TEST_CASE("progress that rounding puts past an edge's end is no step back on 20,000 crooked paths", "[steering]") {
    Random random(88);
    int back = 0, off = 0;
    for (int i = 0; i < test::cases(20'000); ++i) {
        Points points{{0, 0}};
        for (int k = 0; k < 5; ++k) points.push_back(points.back() + randomVec2(random, 1));
        const Path path{.points = points, .closed = random.integer(0, 1) == 0};
        const double length = lengthOf(path);
        Agent agent{};
        double progress = 0;
        for (int k = 0; k < 200; ++k) {
            const PathStep step = followPath(agent, path, progress, 0.5);
            back += step.progress < progress;
            off += step.progress > std::min(progress + 0.5, path.closed ? 1e9 : length) + 1e-14 * (length + progress);
            progress = step.progress;
            agent = moved(agent, step.acceleration, dt);
        }
    }
    CHECK(back == 0);
    CHECK(off == 0);
}

TEST_CASE("paths that lead nowhere are refused by name", "[steering][errors]") {
    const Points one{{0, 0}}, same{{1, 1}, {1, 1}}, strange{{0, 0}, {0, std::nan("")}}, line{{0, 0}, {1, 0}};
    CHECK_THROWS_WITH(followPath({}, {one}, 0, 1), "Path.points: 1 points, not two or more");
    CHECK_THROWS_WITH(followPath({}, {same}, 0, 1), "Path.points: length: 0 is not positive");
    CHECK_THROWS_WITH(followPath({}, {strange}, 0, 1), "Path.points: (0, nan) is not finite");
    CHECK_THROWS_WITH(followPath({}, {line}, -1, 1), "followPath: progress: -1 is negative");
    CHECK_THROWS_WITH(followPath({}, {line}, 0, 0), "followPath: ahead: 0 is not positive");
}
