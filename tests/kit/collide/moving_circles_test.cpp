// SPDX-License-Identifier: MIT
#include <plumb/collide/moving_circles.h>

#include <array>
#include <cmath>
#include <iostream>
#include <span>

#include <plumb/collide/ray_cast.h>
#include <plumb/impact/impact.h>
#include <plumb/math/random.h>

#include "cases.h"
#include "catch.h"

namespace {

using namespace plumb;
using namespace plumb::test;

Vec2 somewhere(Random& random, double size) {
    const double x = random.uniform(-size, size);
    return {x, random.uniform(-size, size)};
}

double circleGapAt(const MovingCircle& a, const MovingCircle& b, long double time) {
    const long double x = (b.position.x() - static_cast<long double>(a.position.x())) +
                          (b.velocity.x() - static_cast<long double>(a.velocity.x())) * time;
    const long double y = (b.position.y() - static_cast<long double>(a.position.y())) +
                          (b.velocity.y() - static_cast<long double>(a.velocity.y())) * time;
    return static_cast<double>(std::sqrt(x * x + y * y) - (static_cast<long double>(a.radius) + b.radius));
}

/// The lecture's loop: on to the impact, reflect, and spend what is left of the step. Returns how often it hit.
int spend(MovingCircle& ball, std::span<const MovingCircle> posts, double step) {
    int hits = 0;
    for (double left = step; left > 0; ++hits) {
        std::optional<Touch> first;
        for (const MovingCircle& post : posts) {
            const std::optional<Touch> touch = firstTouch(ball, post);
            const bool parting = touch && ball.velocity.dot(touch->normal) <= 0;  // from the impact just now
            if (touch && !parting && (!first || touch->time < first->time)) first = touch;
        }
        const double time = first ? std::min(first->time, left) : left;
        ball.position += ball.velocity * time;
        left -= time;
        if (!(left > 0)) break;
        ball.velocity = impact({.velocity = ball.velocity, .inverseMass = 1}, {}, first->normal, {}).velocityA;
    }
    return hits;
}

}  // namespace

// The lecture, slide 26: r = 1, v = 10, (8, 1): t = .6267949192.
TEST_CASE("a circle of 1 m at 10 m/s touches one of 1 m at (8, 1) after .6267949192 s", "[collide][sweep][facts]") {
    const MovingCircle moving{1, {0, 0}, {10, 0}}, still{1, {8, 1}, {0, 0}};
    const std::optional<Touch> touch = firstTouch(moving, still);
    REQUIRE(touch);
    CHECK(std::fabs(touch->time - 0.6267949192) < 5e-11);
    CHECK(std::fabs(touch->time - (8 - std::sqrt(3)) / 10) < 5e-16);
    CHECK((touch->normal - Vec2(std::sqrt(3) / 2, 0.5)).norm() < 1e-15);
    CHECK((touch->point - Vec2(8 - std::sqrt(3) / 2, 0.5)).norm() < 2e-15);
    // The swept capsule of the lecture: a ray at a circle of twice the radius.
    const auto ray = castRay({0, 0}, {10, 0}, Circle{2}, {{8, 1}, {}});
    REQUIRE(ray);
    CHECK(std::fabs(touch->time - ray->fraction) < 5e-16);
}

TEST_CASE("1,000,000 pairs of moving circles touch at the first time that they are no distance apart, if at all",
          "[collide][sweep]") {
    Random random(107);
    int hits = 0, faults = 0;
    double worst = 0;
    const int count = cases(1'000'000);
    for (int i = 0; i < count; ++i) {
        MovingCircle a{random.uniform(0, 2), somewhere(random, 10), somewhere(random, 5)};
        MovingCircle b{random.uniform(0, 2), somewhere(random, 10), somewhere(random, 5)};
        const Vec2 p = b.position - a.position, v = b.velocity - a.velocity;
        if (random.integer(0, 3) == 0)  // nearly past each other
            b.position += perp(v) * ((a.radius + b.radius) * (1 + random.uniform(-1e-6, 1e-6)) / v.norm()) -
                          perp(v) * (perp(v).dot(p) / v.dot(v));
        const std::optional<Touch> touch = firstTouch(a, b);
        // They are nearest when the way is at right angles to what is between them.
        const Vec2 place = b.position - a.position;
        const double nearest = std::max(0.0, -place.dot(v) / v.dot(v)), least = circleGapAt(a, b, nearest);
        if (!touch) {
            faults += least < -1e-14 * 40;
            continue;
        }
        ++hits;
        const double gap = circleGapAt(a, b, touch->time);
        if (touch->time == 0) {
            faults += gap > 1e-14;
            continue;
        }
        // Some ten roundings of places up to 40 m.
        worst = std::max(worst, std::fabs(gap));
        faults += std::fabs(gap) > 4e-14 || touch->time > nearest + 1e-6 || circleGapAt(a, b, 0) < -1e-14;
    }
    std::cout << "[sweep] circles: " << hits << " of " << count << " touch, to " << worst << " m; faults " << faults
              << "\n";
    CHECK(faults == 0);
    CHECK(hits > count / 10);
}

TEST_CASE("circles that part, stand still, or overlap", "[collide][sweep]") {
    const MovingCircle still{1, {0, 0}, {0, 0}};
    CHECK_FALSE(firstTouch(still, {1, {3, 0}, {1, 0}}));
    CHECK_FALSE(firstTouch(still, {1, {3, 0}, {0, 0}}));
    CHECK_FALSE(firstTouch(still, {1, {-5, 2.001}, {9, 0}}));
    CHECK(firstTouch(still, {1, {-5, 1.999}, {9, 0}}));
    const auto inside = firstTouch(still, {1, {1, 0}, {5, 0}});
    REQUIRE(inside);
    CHECK(inside->time == 0);
    CHECK(inside->normal == Vec2(1, 0));
    CHECK(inside->point == Vec2(0.5, 0));
    CHECK_THROWS_WITH(firstTouch({-1, {0, 0}, {0, 0}}, still), "MovingCircle a.radius: -1 is negative");
    CHECK_THROWS_WITH(firstTouch(still, {1, {0, NAN}, {0, 0}}), "MovingCircle b.position: (0, nan) is not finite");
}

TEST_CASE("a ball of 0.5 m between posts 10 m apart spends a second at 100 m/s on 14 impacts, where unfolding has it",
          "[collide][sweep]") {
    // From the middle of a clear way of 10 - 2 * 1.5 = 7 m; unfolded, the way is straight: 3.5 m, then 7 m an impact.
    const std::array posts{MovingCircle{1, {-5, 0}, {0, 0}}, MovingCircle{1, {5, 0}, {0, 0}}};
    MovingCircle ball{0.5, {0, 0}, {100, 0}};
    const int hits = spend(ball, posts, 1);
    CHECK(hits == 14);
    // The 14th, after 3.5 + 13 * 7 = 94.5 m, is on the left post: 5.5 m to the right of where it is hit.
    CHECK(std::fabs(ball.position.x() - (-3.5 + 5.5)) < 1e-12);
    CHECK(ball.velocity == Vec2(100, 0));
}

TEST_CASE("a ball among four posts keeps its speed through 1,000 steps, and never is in a post", "[collide][sweep]") {
    const double far = 1e3;  // posts so large that they all but shut the place in
    const std::array posts{MovingCircle{far, {far + 5, 0}, {0, 0}}, MovingCircle{far, {-far - 5, 0}, {0, 0}},
                           MovingCircle{far, {0, far + 5}, {0, 0}}, MovingCircle{far, {0, -far - 5}, {0, 0}}};
    MovingCircle ball{0.5, {1, 2}, {30, 17}};
    const double speed = ball.velocity.norm();
    int hits = 0;
    double deepest = 0;
    for (int i = 0; i < 1000; ++i) {
        hits += spend(ball, posts, 1.0 / 60);
        for (const MovingCircle& post : posts) deepest = std::min(deepest, circleGapAt(ball, post, 0));
    }
    CHECK(hits > 50);
    // A rounding an impact.
    CHECK(std::fabs(ball.velocity.norm() / speed - 1) < 1e-15 * hits);
    CHECK(deepest > -1e-12);
}
