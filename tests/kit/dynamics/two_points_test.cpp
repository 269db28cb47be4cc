// SPDX-License-Identifier: MIT
// Are the impulses at the two points of a contact those of both together?
#include <plumb/math/detail/two_points.h>

#include <algorithm>
#include <cmath>

#include <plumb/math/random.h>
#include <plumb/plumb.h>
#include "cases.h"
#include "catch.h"
#include "kit/usual_world.h"

using namespace plumb;
using namespace plumb::test;

TEST_CASE("of two points none pulls, and none that pushes approaches, for 100,000 random contacts",
          "[dynamics][property]") {
    using Points = TwoPoints<double>;
    Random random(1);
    const auto pair = [&](double low, double high) {
        return Points::Each{{random.uniform(low, high), random.uniform(low, high)}};
    };
    for (int round = 0; round < cases(100'000); ++round) {
        const double massA = round % 3 == 0 ? 0 : random.uniform(0, 2), massB = random.uniform(0.1, 2);
        const Points::Each a = pair(-3, 3), b = pair(-3, 3), old = pair(0, 2), speed = pair(-3, 3);
        const Points::Each share = round % 2 == 0 ? Points::Each{{1, 1}} : pair(0.1, 1);
        const auto k = [&](int i, int j) { return massA * (1 + a.at[i] * a.at[j]) + massB * (1 + b.at[i] * b.at[j]); };
        const Points points = Points::of({{1 / k(0, 0), 1 / k(1, 1)}}, massA, massB, a, b);
        const Points::Each now = points.normals(old, speed, share);
        for (int i = 0; i < 2; ++i) {
            const double give = (1 / share.at[i] - 1) * k(i, i) * now.at[i];
            const double left = speed.at[i] + k(i, 0) * (now.at[0] - old.at[0]) + k(i, 1) * (now.at[1] - old.at[1]);
            // The points are coupled a little less than they are (see TwoPoints::loose).
            const double error = 1e-4 * (1 + std::fabs(k(0, 1)) * (now.at[0] + now.at[1] + 4));
            REQUIRE(now.at[i] >= 0);
            REQUIRE(left + give > -error);
            if (now.at[i] > 0) REQUIRE(left + give < error);
        }
    }
}

TEST_CASE("a plank that falls flat stays flat", "[dynamics][symptom]") {
    for (const double friction : {0.0, 0.6})
        for (const Vec2& half : {Vec2(1, 0.2), Vec2(0.5, 0.5), Vec2(0.2, 0.2)})
            for (const double rate : {30.0, 60.0, 240.0})
                for (int i = 0; i < cases(300); ++i) {
                    const double fall = 0.5 + 0.0571 * i;
                    World world({.gravity = {0, -9.81}});
                    world.add({.type = BodyType::Static,
                               .position = {0, -1},
                               .shapes = {plumb::box({20, 1}, {.friction = friction})}});
                    const BodyId plank = world.add(
                        {.position = {0, half.y() + fall}, .shapes = {plumb::box(half, {.friction = friction})}});
                    double turned = 0, up = 0;
                    const int ticks = static_cast<int>((std::sqrt(2 * fall / 9.81) + 0.5) * rate);
                    for (int tick = 0; tick < ticks; ++tick) {
                        world.step(1 / rate);
                        turned = std::max(turned, std::fabs(world.body(plank).angle()));
                        up = std::max(up, world.body(plank).velocity().y());
                    }
                    INFO("friction " << friction << ", " << 2 * half.x() << " m, from " << fall << " m, " << rate
                                     << " Hz");
                    REQUIRE(turned < 0.002);
                    REQUIRE(up < 0.01);
                }
}

TEST_CASE("a box slides to the left as it slides to the right, at mu g, and does not sink in", "[dynamics][symptom]") {
    for (const double friction : {0.2, 0.8, 1.0, 1.2, 1.5})
        for (const Vec2& half : {Vec2(0.5, 0.25), Vec2(0.5, 0.1), Vec2(1, 0.3)}) {
            double way[2] = {0, 0}, deepest = 0;
            for (const int side : {0, 1}) {
                World world({.gravity = {0, -9.81}});
                const Material material{.friction = friction};
                world.add(
                    {.type = BodyType::Static, .position = {0, -0.5}, .shapes = {plumb::box({100, 0.5}, material)}});
                const BodyId box = world.add({.position = {0, half.y()},
                                              .velocity = {side == 0 ? 10.0 : -10.0, 0},
                                              .shapes = {plumb::box(half, material)}});
                for (int tick = 0; tick < 360; ++tick) {
                    world.step(1.0 / 60);
                    for (const Contact& contact : world.body(box).contacts())
                        for (const ContactPoint& point : contact.points) deepest = std::max(deepest, -point.separation);
                }
                way[side] = std::fabs(world.body(box).position().x());
            }
            INFO("friction " << friction << ", " << half.transpose());
            CHECK(std::fabs(way[0] - way[1]) < 1e-4);
            CHECK(std::fabs(way[0] - 100 / (2 * friction * 9.81)) < 0.01 * way[0]);
            CHECK(deepest < 2.5e-4);
        }
}
