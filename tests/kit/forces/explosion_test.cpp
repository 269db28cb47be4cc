// SPDX-License-Identifier: MIT
#include <plumb/forces/explosion.h>

#include <cmath>
#include <vector>

#include <plumb/math/random.h>
#include <plumb/math/rot.h>

#include "cases.h"
#include "catch.h"

using namespace plumb;

TEST_CASE("a blast of 3 N s/m at half its falloff gives 2 m of width 3 N s", "[forces][law]") {
    const Explosion explosion{.center = {1, 1}, .radius = 2, .falloff = 4, .impulsePerLength = 3};
    const Blast blast = blastOn(explosion, {.nearest = {5, 1}, .centerOfMass = {6, 1}, .width = 2});
    CHECK(blast.impulse == Vec2(3, 0));
    CHECK(blast.point == Vec2(5, 1));
    CHECK(blastOn(explosion, {.nearest = {1, 2.5}, .width = 2}).impulse == Vec2(0, 6));  // within the radius, in full
    CHECK(blastOn(explosion, {.nearest = {8, 1}, .width = 2}).impulse == Vec2(0, 0));    // out of reach
    CHECK(blastOn(explosion, {.nearest = {1, -5}, .width = 2}).impulse == Vec2(0, 0));   // just out of reach
    CHECK(blastOn({.falloff = 0}, {.nearest = {1, 0}, .width = 2}).impulse == Vec2(2, 0));  // an edge without falloff
    CHECK(blastOn({.falloff = 0}, {.nearest = {1.001, 0}, .width = 2}).impulse == Vec2(0, 0));
    CHECK(blastOn({.impulsePerLength = -1}, {.nearest = {1, 0}, .width = 2}).impulse == Vec2(-2, 0));
}

TEST_CASE("a blast within a body pushes its centre of mass away", "[forces]") {
    const Blast blast = blastOn({}, {.nearest = {0, 0}, .centerOfMass = {0, 0.5}, .width = 2});
    CHECK(blast.impulse == Vec2(0, 2));
    CHECK(blast.point == Vec2(0, 0.5));
    CHECK(blastOn({}, {.nearest = {0, 0}, .centerOfMass = {0, 0}, .width = 2}).impulse == Vec2(0, 0));
}

TEST_CASE("a wall cut into pieces is hit as hard as a whole, 1,000 times", "[forces][law]") {
    // Of a fence that is everywhere as far from the blast: each piece's width is that of its chord.
    Random random(31);
    const Explosion explosion{.center = {0, 0}, .radius = 1, .falloff = 3, .impulsePerLength = 2};
    for (int i = 0; i < 1000; ++i) {
        const double distance = random.uniform(0.1, 4.5);
        const int pieces = random.integer(3, 40);
        Vec2 sum(0, 0);
        double sizes = 0;
        for (int k = 0; k < pieces; ++k) {
            const Vec2 middle = Rot::fromAngle(2 * M_PI * k / pieces) * Vec2(distance, 0);
            const Blast blast = blastOn(explosion, {.nearest = middle, .width = 2 * M_PI * distance / pieces});
            sum += blast.impulse;
            sizes += blast.impulse.norm();
        }
        CHECK(sum.norm() < 1e-13);
        const double full = 2 * 2 * M_PI * distance;
        CHECK(std::fabs(sizes - full * std::clamp((4 - distance) / 3, 0.0, 1.0)) < 1e-12);
    }
}

TEST_CASE("a box of 2 m by 1 m is 1 m across from its end, 2 m from its side, 3 / sqrt(2) m from 45 degrees",
          "[forces]") {
    const std::vector<Vec2> box{{-1, -0.5}, {1, -0.5}, {1, 0.5}, {-1, 0.5}};
    CHECK(widthAcross(box, 0, {3, 0}) == 1);
    CHECK(widthAcross(box, 0, {0, -2}) == 2);
    CHECK(std::fabs(widthAcross(box, 0, {1, 1}) - 3 / std::sqrt(2.0)) < 1e-15);
    CHECK(widthAcross(box, 0.25, {3, 0}) == 1.5);
    CHECK(widthAcross(std::vector<Vec2>{{7, 8}}, 0.5, {1, 2}) == 1);
    CHECK(widthAcross({}, 0.5, {1, 2}) == 0);
    CHECK(widthAcross(box, 0.5, {0, 0}) == 0);
}

TEST_CASE("explosions that nothing makes are refused by name", "[forces][errors]") {
    CHECK_THROWS_WITH(blastOn({.radius = -1}, {}), "Explosion.radius: -1 is negative");
    CHECK_THROWS_WITH(blastOn({.falloff = -1}, {}), "Explosion.falloff: -1 is negative");
    CHECK_THROWS_WITH(blastOn({.impulsePerLength = std::nan("")}, {}), "Explosion.impulsePerLength: nan is not finite");
    CHECK_THROWS_WITH(blastOn({}, {.width = -1}), "BlastTarget.width: -1 is negative");
    CHECK_THROWS_WITH(widthAcross({}, -1, {1, 0}), "widthAcross: radius: -1 is negative");
}
