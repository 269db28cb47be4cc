// SPDX-License-Identifier: MIT
#include <plumb/impact/particles.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include <plumb/math/random.h>

#include "cases.h"
#include "catch.h"
#include "numbers.h"

using namespace plumb;
using namespace plumb::test;

namespace {

struct Sums {
    double momentum = 0, energy = 0, size = 0;
};

Sums sumsOf(const std::vector<LineParticle>& row, const std::vector<double>& velocities) {
    Sums sums;
    for (std::size_t i = 0; i < row.size(); ++i) {
        sums.momentum += row[i].mass * velocities[i];
        sums.energy += row[i].mass * velocities[i] * velocities[i] / 2;
        sums.size += row[i].mass * std::fabs(velocities[i]);
    }
    return sums;
}

std::vector<double> velocitiesOf(const std::vector<LineParticle>& row) {
    std::vector<double> velocities;
    for (const LineParticle& particle : row) velocities.push_back(particle.velocity);
    return velocities;
}

std::vector<LineParticle> randomRow(Random& random, bool alike) {
    std::vector<LineParticle> row;
    const int size = random.integer(2, 8);
    for (int i = 0; i < size; ++i) row.push_back({alike ? 1 : std::exp(random.uniform(-2, 2)), random.uniform(-5, 5)});
    return row;
}

}  // namespace

// Worked numbers of response, 1D impact (Newton).
TEST_CASE("on a line, 2 kg at 3 m/s and 1 kg at -1 m/s part at 1/3 and 13/3 m/s, or at e = 0.5 at 1 and 3",
          "[impact][facts][law]") {
    const LineImpact elastic = collideInLine({2, 3}, {1, -1});
    CHECK(std::fabs(elastic.velocityA - 1.0 / 3) < 1e-15);
    CHECK(std::fabs(elastic.velocityB - 13.0 / 3) < 1e-15);
    CHECK(std::fabs(elastic.impulse - 16.0 / 3) < 1e-15);
    const LineImpact lossy = collideInLine({2, 3}, {1, -1}, 0.5);
    CHECK(std::fabs(lossy.velocityA - 1) < 1e-15);
    CHECK(std::fabs(lossy.velocityB - 3) < 1e-15);
}

// Worked numbers of response, 2D equal discs: without friction they part as particles do.
TEST_CASE("equal particles that meet 30 degrees off the line part as the lecture says", "[impact][facts][law]") {
    const Vec2 normal(std::sqrt(3.0) / 2, 0.5);
    const ImpactResult elastic = collideParticles({.velocity = {1, 0}}, {}, normal);
    CHECK((elastic.velocityA - Vec2(0.25, -0.4330127019)).norm() < 1e-10);
    CHECK((elastic.velocityB - Vec2(0.75, 0.4330127019)).norm() < 1e-10);
    const ImpactResult lossy = collideParticles({.velocity = {1, 0}}, {}, normal, {.restitution = 0.8});
    CHECK((lossy.velocityA - Vec2(0.325, -0.3897114317)).norm() < 1e-10);
    CHECK((lossy.velocityB - Vec2(0.675, 0.3897114317)).norm() < 1e-10);
}

TEST_CASE("a particle at (3, -4) m/s leaves the floor at (3, 2) for e = 0.5, and at (1.8, 2) with a friction of 0.2",
          "[impact][law]") {
    CHECK((bounceOffWall({3, -4}, {0, 1}, {.restitution = 0.5}) - Vec2(3, 2)).norm() < 1e-15);
    CHECK((bounceOffWall({3, -4}, {0, 1}, {.restitution = 0.5, .friction = 0.2}) - Vec2(1.8, 2)).norm() < 1e-15);
    CHECK((bounceOffWall({3, -4}, {0, 1}, {.restitution = 0.5, .friction = 2}) - Vec2(0, 2)).norm() < 1e-15);
    CHECK(bounceOffWall({3, 4}, {0, 1}) == Vec2(3, 4));  // it leaves already
    CHECK(collideInLine({infinity, 0}, {1, -2}).velocityB == 2);
    CHECK(collideInLine({1, 2}, {infinity, -1}).velocityA == -4);  // a bat comes towards it
}

// Worked numbers of response, cradle (Herrmann and Seitz): n in, n out, pair after pair; five balls, two in: two out.
TEST_CASE("in a cradle of five as many balls go out as come in", "[impact][facts][law]") {
    for (std::size_t n = 1; n <= 5; ++n) {
        std::vector<LineParticle> balls(5);
        for (std::size_t i = 0; i < n; ++i) balls[i].velocity = 2;
        const RowImpact after = collideRow(balls);
        for (std::size_t i = 0; i < 5; ++i) CHECK(after.velocities[i] == (i < 5 - n ? 0 : 2));
        CHECK(after.impacts == static_cast<int>(n * (5 - n)));
        CHECK(after.parted);
    }
}

// Worked numbers of response, cannon (Harter, "Velocity amplification in collision experiments involving superballs",
// 1971).
TEST_CASE("3 kg and 1 kg that come down at 1 m/s leave the floor at 0 and 2 m/s: 4 times as high",
          "[impact][facts][law]") {
    const std::vector<LineParticle> balls{{infinity, 0}, {3, -1}, {1, -1}};
    const RowImpact after = collideRow(balls);
    CHECK(after.velocities == std::vector<double>{0, 0, 2});
    CHECK(after.velocities[2] * after.velocities[2] == 4);
    // v (3 m1 - m2) / (m1 + m2), for any masses: the ball above meets one that comes up at v.
    for (const double mass : {0.5, 1.0, 7.0})
        CHECK(std::fabs(collideInLine({mass, 1}, {1, -1}).velocityB - (3 * mass - 1) / (mass + 1)) < 1e-14);
}

TEST_CASE("three balls dropped on each other, each far lighter, rise 49 times as high", "[impact][facts][law]") {
    // (2^n - 1)^2 for n balls; each mass ratio of 1e-9 takes some 1e-9 of the speed at each impact.
    double mass = 1;
    std::vector<LineParticle> balls{{infinity, 0}};
    for (int n = 1; n <= 6; ++n, mass *= 1e-9) {
        balls.push_back({mass, -1});
        const double speed = collideRow(balls).velocities.back();
        const double limit = std::pow(2, n) - 1;
        CHECK(std::fabs(speed * speed / (limit * limit) - 1) < 40 * 1e-9);
    }
}

TEST_CASE("alike elastic particles in a row hand their velocities on until they are sorted, 100,000 times",
          "[impact][law]") {
    Random random(61);
    double worst = 0;
    for (int i = 0; i < test::cases(100'000); ++i) {
        const std::vector<LineParticle> row = randomRow(random, true);
        std::vector<double> sorted = velocitiesOf(row);
        std::sort(sorted.begin(), sorted.end());
        const RowImpact after = collideRow(row);
        for (std::size_t k = 0; k < row.size(); ++k)
            worst = std::max(worst, std::fabs(after.velocities[k] - sorted[k]));
    }
    std::cout << "impact: rows of alike particles are off by at most " << worst << " m/s\n";
    CHECK(worst < 28 * 4 * 10 * 1.1e-16);  // up to 28 impacts, of some four roundings of 10 m/s each
}

TEST_CASE("rows of any particles keep their momentum, gain no energy, and part, 100,000 times", "[impact][law]") {
    Random random(62);
    double momentum = 0, gain = 0, loss = 0, approach = 0;
    int unparted = 0, most = 0;
    for (int i = 0; i < test::cases(100'000); ++i) {
        const std::vector<LineParticle> row = randomRow(random, false);
        const double e = i % 2 == 0 ? 1 : random.uniform(0, 1);
        const Sums before = sumsOf(row, velocitiesOf(row));
        const RowImpact after = collideRow(row, e);
        const Sums sums = sumsOf(row, after.velocities);
        momentum = std::max(momentum, std::fabs(sums.momentum - before.momentum) / before.size);
        gain = std::max(gain, sums.energy / before.energy - 1);
        if (e == 1) loss = std::max(loss, 1 - sums.energy / before.energy);
        for (std::size_t k = 0; k + 1 < row.size(); ++k)
            approach = std::max(approach, after.velocities[k] - after.velocities[k + 1]);
        unparted += !after.parted;
        most = std::max(most, after.impacts);
    }
    std::cout << "impact: rows keep their momentum to " << momentum << ", gain at most " << gain
              << " of their energy, and part within " << most << " impacts\n";
    const double rounding = 10 * most * 1.1e-16;  // some ten roundings an impact
    CHECK(momentum < rounding);
    CHECK(gain < rounding);
    CHECK(loss < rounding);
    CHECK(approach <= 1e-12 * 5);
    CHECK(unparted == 0);
}

TEST_CASE("a row stops at the most impacts it may take, and one of none or one is as it was", "[impact]") {
    const std::vector<LineParticle> pressed{{infinity, 1}, {1, 0}, {1, 0}, {infinity, -1}};
    const RowImpact between = collideRow(pressed, 1, 1000);
    CHECK_FALSE(between.parted);
    CHECK(between.impacts == 1000);
    CHECK(collideRow({}).velocities.empty());
    const std::vector<LineParticle> one{{2, 3}};
    CHECK(collideRow(one).velocities == std::vector<double>{3});
}

TEST_CASE("particles of no mass are refused by name", "[impact][errors]") {
    CHECK_THROWS_WITH(collideInLine({0, 1}, {1, 0}), "Particle a.mass: 0 is not positive");
    CHECK_THROWS_WITH(collideParticles({}, {.mass = std::nan("")}, {1, 0}), "Particle b.mass: nan is not finite");
    CHECK_THROWS_WITH(collideInLine({1, 1}, {1, 0}, 2), "ImpactLaw.restitution: 2 is not within 0 to 1");
}

TEST_CASE("a row of what nothing is made of is refused, whether it collides or not", "[impact][errors]") {
    const auto row = [](const LineParticle& strange, double restitution = 1, int most = 10) {
        return collideRow(std::vector<LineParticle>{{1, 1}, {1, 2}, strange}, restitution, most);
    };
    CHECK(row({1, 3}).impacts == 0);
    CHECK_THROWS_WITH(row({-1, 3}), "LineParticle.mass: -1 is not positive");
    CHECK_THROWS_WITH(row({std::nan(""), 3}), "LineParticle.mass: nan is not finite");
    CHECK_THROWS_WITH(row({1, std::nan("")}), "LineParticle.velocity: nan is not finite");
    CHECK_THROWS_WITH(row({1, infinity}), "LineParticle.velocity: inf is not finite");
    CHECK_THROWS_WITH(row({1, 3}, 5), "collideRow: restitution: 5 is not within 0 to 1");
    CHECK_THROWS_WITH(row({1, 3}, 1, -1), "collideRow: maxImpacts: -1 is negative");
    CHECK_THROWS_WITH(collideRow({}, std::nan("")), "collideRow: restitution: nan is not finite");
}

TEST_CASE("speeds and impulses beyond all numbers are refused, not given back", "[impact][errors]") {
    CHECK_THROWS_WITH(collideInLine({1, infinity}, {1, 0}), "Particle a.velocity: (inf, 0) is not finite");
    CHECK_THROWS_WITH(bounceOffWall({0, -infinity}, {0, 1}), "bounceOffWall: velocity: (0, -inf) is not finite");
    CHECK_THROWS_WITH(collideInLine({1e308, 1}, {1e308, -1}), "impact: normalImpulse: inf is not finite");
    CHECK(collideInLine({1e307, 1}, {1e307, -1}).velocityA == -1);
}
