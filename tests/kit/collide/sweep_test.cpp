// SPDX-License-Identifier: MIT
#include <plumb/collide/sweep.h>

#include <array>
#include <cmath>

#include <plumb/collide/distance.h>
#include <plumb/math/random.h>
#include "cases.h"
#include "catch.h"

using namespace plumb;
using namespace plumb::test;

namespace {

Vec2 randomVector(Random& random, double size) {
    return {random.uniform(-size, size), random.uniform(-size, size)};
}

Shape randomSweptShape(Random& random) {
    switch (random.integer(0, 3)) {
        case 0: return Circle{random.uniform(0.05, 1), randomVector(random, 0.5)};
        case 1: return boxPolygon({random.uniform(0.05, 2), random.uniform(0.01, 0.5)});
        case 2: return Segment{randomVector(random, 2), randomVector(random, 2)};
        default: return Capsule{randomVector(random, 1), randomVector(random, 1), random.uniform(0.05, 0.5)};
    }
}

Sweep randomSweep(Random& random) {
    return {randomVector(random, 2.5), randomVector(random, 4), random.uniform(-3, 3), random.uniform(-4, 4),
            randomVector(random, 0.2)};
}

double separationAt(const SweptShape& a, const SweptShape& b, double time) {
    return distance(*a.shape, poseAt(a.sweep, time), *b.shape, poseAt(b.sweep, time)).separation;
}

}  // namespace

TEST_CASE("a swept shape meets another when sampling ten thousand poses says so", "[collide][sweep]") {
    constexpr int samples = 10000;
    Random random(11);
    int met = 0;
    for (int round = 0; round < allCases(300); ++round) {
        INFO("round " << round);
        const Shape wall = randomSweptShape(random), shape = randomSweptShape(random);
        const SweptShape a{&wall, randomSweep(random), 0};
        const SweptShape b{&shape, randomSweep(random), 3.1};  // 2 sqrt(2) at most, and 0.2 sqrt(2) off the centre
        const double limit = random.uniform(-0.1, 0.1);
        const std::optional<double> time = timeOfApproach(a, b, limit, 0);
        int first = 0;
        while (first <= samples && separationAt(a, b, first / double(samples)) > limit) ++first;
        if (!time) {
            CHECK(first > samples);
            continue;
        }
        ++met;
        // Between two samples the way is 0.005 m long at most, and the search may end 0.01 mm early.
        CHECK(separationAt(a, b, *time) < limit + 2e-5);
        CHECK(*time <= first / double(samples));
        if (*time > 0) CHECK(separationAt(a, b, *time) > limit - 1e-9);
    }
    CHECK(met > allCases(50));
    CHECK(met < allCases(290));
}

TEST_CASE("a disc at 3 m in a step meets a wall 1 m off after a third of the step", "[collide][sweep]") {
    const Shape wall = Segment{{-5, 0}, {5, 0}};
    const Shape disc = Circle{0.1};
    Sweep sweep;
    sweep.start = {0, 1.1};
    sweep.shift = {2, -3};
    const auto time = timeOfApproach({&wall, {}, 0}, {&disc, sweep, 0}, 0, 0);
    REQUIRE(time);
    CHECK(std::fabs(*time - 1.0 / 3) < 1e-5);
    sweep.shift = {2, 3};
    CHECK_FALSE(timeOfApproach({&wall, {}, 0}, {&disc, sweep, 0}, 0, 0));
}
