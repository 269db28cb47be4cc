// SPDX-License-Identifier: MIT
#include <plumb/steering/avoid.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <limits>
#include <vector>

#include <plumb/steering/blend.h>
#include <plumb/steering/seek.h>
#include <plumb/steering/wander.h>

#include "cases.h"
#include "catch.h"
#include "kit/steering/agents.h"

using namespace plumb;
using namespace agents;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Vec2 firstOf(const Agent& agent, const Vec2& first, const Vec2& then) {
    return steerByPriority(agent, std::array{WeightedSteering{first}, WeightedSteering{then}});
}

/// Trees on a square of 40 m, with room between any two for the agent, its clearance and its sharpest turn.
std::vector<RoundObstacle> randomWood(Random& random, const Agent& agent, double clearance) {
    const double turn = 2 * agent.maxSpeed * agent.maxSpeed / agent.maxAcceleration;
    const double room = 2 * (agent.radius + clearance) + turn + 2 * agent.maxSpeed * agent.responseTime;
    std::vector<RoundObstacle> trees;
    for (int tries = 0; tries < 200; ++tries) {
        const RoundObstacle tree{randomVec2(random, 20), random.uniform(0.2, 3)};
        const bool fits = std::ranges::all_of(trees, [&](const RoundObstacle& other) {
            return (other.center - tree.center).norm() > other.radius + tree.radius + room;
        });
        if (fits) trees.push_back(tree);
    }
    return trees;
}

double distanceToWall(const WallSegment& wall, const Vec2& p) {
    const Vec2 along = wall.end - wall.start;
    const double t = std::clamp((p - wall.start).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (p - wall.start - t * along).norm();
}

}  // namespace

TEST_CASE("who avoids first and seeks then comes through 10,000 woods without touching a tree", "[steering]") {
    Random random(91);
    double least = infinity;
    int touched = 0, through = 0, trees = 0, first = -1;
    const int woods = test::cases(10'000);
    for (int i = 0; i < woods; ++i) {
        Agent agent = randomAgent(random);
        const double clearance = 0.2 + 0.1 * agent.radius;
        const std::vector<RoundObstacle> wood = randomWood(random, agent, clearance);
        trees += static_cast<int>(wood.size());
        agent.position = {-30, random.uniform(-15, 15)};
        agent.velocity = {agent.maxSpeed, 0};
        const Vec2 target(30, random.uniform(-15, 15));
        double gap = infinity;
        for (int k = 0; k * dt < 150 / agent.maxSpeed && (target - agent.position).norm() > 1; ++k) {
            agent = moved(agent, firstOf(agent, avoidObstacles(agent, wood, clearance), seek(agent, target)), dt);
            for (const RoundObstacle& tree : wood)
                gap = std::min(gap, (tree.center - agent.position).norm() - tree.radius - agent.radius);
        }
        through += (target - agent.position).norm() <= 1 + agent.maxSpeed * dt;
        if (gap < 0 && touched++ == 0) first = i;
        least = std::min(least, gap / clearance);
    }
    std::cout << "steering: in " << woods << " woods of " << trees / woods << " trees " << touched
              << " touched one (first " << first << "), " << through << " came through; the least gap was " << least
              << " of the clearance\n";
    CHECK(touched == 0);
    CHECK(through == woods);
}

TEST_CASE("who keeps off walls stays in 10,000 rooms, with a screen in the middle", "[steering]") {
    Random random(92);
    double least = infinity;
    int touched = 0, stuck = 0;
    const int rooms = test::cases(10'000);
    for (int i = 0; i < rooms; ++i) {
        Agent agent = randomAgent(random);
        const double stop =
            agent.maxSpeed * agent.maxSpeed / agent.maxAcceleration + 2 * agent.maxSpeed * agent.responseTime;
        const double half = 2 * (agent.radius + 0.2 + stop) * random.uniform(1, 3);
        // A room of 3 to 7 corners, none sharper than 60 degrees, and a screen in its middle.
        std::vector<WallSegment> walls;
        const int corners = random.integer(3, 7);
        const auto corner = [&](int k) {
            const double angle = 2 * M_PI * k / corners;
            return Vec2(2 * half * Vec2(std::cos(angle), std::sin(angle)));
        };
        for (int k = 0; k < corners; ++k) walls.push_back({corner(k), corner(k + 1)});
        const Vec2 screen = 0.2 * half * randomDirection(random);
        walls.push_back({-screen, screen});
        agent.position = 0.6 * half * randomDirection(random);
        agent.velocity = {0, 0};
        WanderState state{.random = Random(static_cast<std::uint64_t>(i))};
        double gap = infinity, way = 0;
        for (int k = 0; k < 20 * 60; ++k) {
            const WanderStep step = wander(agent, state, dt);
            state = step.state;
            const Vec2 before = agent.position;
            agent = moved(agent, firstOf(agent, avoidWalls(agent, walls), step.acceleration), dt);
            way += (agent.position - before).norm();
            for (const WallSegment& wall : walls)
                gap = std::min(gap, distanceToWall(wall, agent.position) - agent.radius);
        }
        touched += gap < 0;
        stuck += way < 5 * agent.maxSpeed;
        least = std::min(least, gap);
    }
    std::cout << "steering: in " << rooms << " rooms " << touched << " touched a wall, " << stuck
              << " got stuck; the least gap was " << least << " m of 0.2 m\n";
    CHECK(touched == 0);
    CHECK(stuck == 0);
}

TEST_CASE("nothing is avoided that is not in the way", "[steering]") {
    const Agent agent{.velocity = {3, 0}};
    const std::vector<RoundObstacle> aside{{{5, 3}, 1}, {{-3, 0}, 1}, {{40, 0}, 1}};
    CHECK(avoidObstacles(agent, aside) == Vec2(0, 0));
    const std::vector<WallSegment> along{{{-9, 1}, {9, 1}}, {{-5, -5}, {-5, 5}}, {{30, -1}, {30, 1}}};
    CHECK(avoidWalls(agent, along) == Vec2(0, 0));
    CHECK(avoidObstacles(agent, {}) == Vec2(0, 0));
    CHECK(avoidWalls(agent, {}) == Vec2(0, 0));
}

TEST_CASE("a tree ahead is passed on the side where it is nearer to", "[steering]") {
    const Agent agent{.velocity = {3, 0}};
    CHECK(avoidObstacles(agent, std::vector<RoundObstacle>{{{3, 0.5}, 1}}).y() < 0);
    CHECK(avoidObstacles(agent, std::vector<RoundObstacle>{{{3, -0.5}, 1}}).y() > 0);
    CHECK(avoidObstacles(agent, std::vector<RoundObstacle>{{{3, 0}, 1}}).y() != 0);
    // Of two, the first in its way counts.
    CHECK(avoidObstacles(agent, std::vector<RoundObstacle>{{{3.5, -0.5}, 1}, {{3, 0.5}, 1}}).y() < 0);
}

TEST_CASE("who stands still drifts away from no tree, whichever side it is on", "[steering]") {
    Random random(93);
    int drifted = 0;
    for (int i = 0; i < test::cases(10'000); ++i) {
        Agent agent = randomAgent(random);
        agent.velocity = {0, 0};
        const double touching = agent.radius + 1 + 0.2;
        const RoundObstacle tree{agent.position + randomOffset(random, touching + 1e-9, touching + 5), 1};
        drifted += avoidObstacles(agent, std::array{tree}) != Vec2(0, 0);
    }
    CHECK(drifted == 0);
    // It leaves for the place that it wants, from trees on that side or the other.
    for (const double side : {2.0, -2.0}) {
        const std::array trees{RoundObstacle{{side, 0}, 0.5}};
        Agent agent{};
        double furthest = 0;
        for (int k = 0; k < 300; ++k) {
            agent = moved(agent, firstOf(agent, avoidObstacles(agent, trees), seek(agent, {-10, 0})), dt);
            furthest = std::max(furthest, agent.position.x());
        }
        CHECK(agent.position.x() < -8);
        CHECK(furthest == 0);
    }
}

TEST_CASE("who stands in a tree or in a wall goes out of it", "[steering]") {
    const Agent agent{.position = {1, 2}};
    CHECK(avoidObstacles(agent, std::vector<RoundObstacle>{{{1.5, 2}, 1}}).x() < 0);
    CHECK(avoidWalls(agent, std::vector<WallSegment>{{{0, 2.1}, {5, 2.1}}}).y() < 0);
}

TEST_CASE("who stands on a tree's middle or right on a wall goes on, or back to where it came from", "[steering]") {
    const std::vector<RoundObstacle> tree{{{1, 2}, 1}};
    const std::vector<WallSegment> wall{{{0, 2}, {5, 2}}}, post{{{1, 2}, {1, 2}}};
    const Agent still{.position = {1, 2}};
    CHECK(avoidObstacles(still, tree) == Vec2(6, 0));
    CHECK(avoidWalls(still, wall) == Vec2(0, 6));
    CHECK(avoidWalls(still, post) == Vec2(-6, 0));
    const Agent falling{.position = {1, 2}, .velocity = {0, -1}}, rising{.position = {1, 2}, .velocity = {0, 1}};
    CHECK(avoidObstacles(falling, tree) == Vec2(0, -6));
    CHECK(avoidWalls(falling, wall).y() > 0);
    CHECK(avoidWalls(rising, wall).y() < 0);
    CHECK(avoidWalls(rising, post).y() < 0);
    // All the way out, from any of them.
    Random random(94);
    int inside = 0;
    for (int i = 0; i < test::cases(1'000); ++i) {
        Agent agent = randomAgent(random);
        if (random.integer(0, 1) == 0) agent.velocity = {0, 0};
        const Vec2 place = agent.position, along = randomDirection(random);
        const std::vector<RoundObstacle> here{{place, 1}};
        const std::vector<WallSegment> there{{place, place + 50 * along}, {place - 50 * along, place}};
        Agent first = agent, second = agent;
        for (int k = 0; k * dt < 60; ++k) {
            first = moved(first, avoidObstacles(first, here), dt);
            second = moved(second, avoidWalls(second, there), dt);
        }
        inside += (first.position - place).norm() < agent.radius + 1;
        inside += distanceToWall(there[0], second.position) < agent.radius;
        inside += distanceToWall(there[1], second.position) < agent.radius;
    }
    CHECK(inside == 0);
}

TEST_CASE("obstacles that nothing is are refused by name", "[steering][errors]") {
    CHECK_THROWS_WITH(avoidObstacles({}, std::vector<RoundObstacle>{{{0, 0}, -1}}),
                      "RoundObstacle.radius: -1 is negative");
    CHECK_THROWS_WITH(avoidObstacles({}, std::vector<RoundObstacle>{{{0, std::nan("")}, 1}}),
                      "RoundObstacle.center: (0, nan) is not finite");
    CHECK_THROWS_WITH(avoidWalls({}, std::vector<WallSegment>{{{0, std::nan("")}, {1, 0}}}),
                      "WallSegment.start: (0, nan) is not finite");
    CHECK_THROWS_WITH(avoidWalls({}, {}, -1), "avoidWalls: clearance: -1 is negative");
}
