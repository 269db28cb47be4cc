// SPDX-License-Identifier: MIT
#include "games/artillery/played.h"

#include <plumb/kinematics/linear_drag.h>
#include <cmath>

#include "cases.h"
#include "catch.h"

using namespace plumb;
using namespace plumb::games::artillery;
using namespace plumb::games::artillery::test;

namespace {

/// The elevation is rounded by up to 0.05 degrees, which moves a hit by at most this share of the way: the range is
/// R(a) ~ sin 2a, so dR / R = 2 cot 2a da, which at 10 degrees is 2 * 2.75 * 0.00087. The rest is the shell's radius
/// and its way in one tick.
double allowedMiss(double way) {
    return 0.005 * way + shellRadius + 0.35;
}

}  // namespace

TEST_CASE("without aiming error the computer's first shot hits across a plain, in still air and in wind up to 14 m/s",
          "[games][artillery]") {
    for (const double wind : {0.0, 4.0, 8.0, 14.0})
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            Battle battle({.seed = seed, .wind = wind}, Terrain(3.0), {-25, 25});
            const FirstShot shot = firstShot(battle, unerring);
            CAPTURE(seed, shot.wind, shot.at.x(), shot.at.y());
            REQUIRE(std::abs(shot.wind) <= wind);
            REQUIRE(shot.fired == shot.meant);
            REQUIRE(shot.wentOff);
            REQUIRE(shot.miss <= allowedMiss(50));
            REQUIRE(battle.healthOf(1 - battle.crew()) <= fullHealth - weapons[0].damage / 2);
        }
}

TEST_CASE("without aiming error the computer's first shot hits on 100 islands in wind and on 100 without wind",
          "[games][artillery]") {
    for (const double wind : {0.0, 12.0})
        for (int seed = 1; seed <= plumb::test::cases(100); ++seed) {
            Battle battle({.seed = static_cast<std::uint64_t>(seed), .wind = wind});
            const FirstShot shot = firstShot(battle, unerring);
            CAPTURE(seed, shot.wind, shot.at.x(), shot.at.y());
            REQUIRE(shot.wentOff);
            // The miss that the computer accepts, and the shell's way in the tick of its explosion.
            REQUIRE(shot.miss <= 1.0 + fastestShot / 60);
            REQUIRE(battle.healthOf(1 - battle.crew()) < gunnersEach * fullHealth);
        }
}

TEST_CASE("firing solutions pass their target within 0.5 % of the way, on low and high arcs", "[games][artillery]") {
    const Terrain plain(0.0);
    Random random(5);
    int low = 0, high = 0;
    for (int i = 0; i < plumb::test::cases(200); ++i) {
        const FireTask task{.gunner = {random.uniform(-28, -5), random.uniform(1, 12)},
                            .target = {random.uniform(5, 28), random.uniform(1, 12)},
                            .wind = random.uniform(-14, 14)};
        for (const FireSolution& solution : fireSolutions(task, plain)) {
            const Vec2 direction = directionOf(solution.aim);
            const PointMotion launch{task.gunner + muzzleFrom(direction), speedOf(solution.aim.charge) * direction};
            const DragLaw law{dragRate, {task.wind, 0}, {0, -gravity}};
            // The path's nearest point to the target, around the predicted time.
            double nearest = 1e9;
            for (double t = 0.9 * solution.time; t < 1.1 * solution.time; t += solution.time / 2000)
                nearest = std::min(nearest, (moveWithDrag(launch, law, t).position - task.target).norm());
            const double path = speedOf(solution.aim.charge) * solution.time;
            REQUIRE(nearest < 0.005 * path);
            (solution.aim.elevation > 500 ? high : low) += 1;
        }
    }
    REQUIRE(low > plumb::test::cases(1000));
    REQUIRE(high > plumb::test::cases(1000));
}

TEST_CASE("a firing solution clears a ridge of 14 m that blocks the straight line to the target",
          "[games][artillery]") {
    Terrain ridge(2.0);
    ridge.level({{0, 2, 14}});
    const FireTask task{.gunner = {-20, 2.9}, .target = {20, 2.9}, .wind = 3};
    const std::vector<FireSolution> solutions = fireSolutions(task, ridge);
    REQUIRE(!solutions.empty());
    for (const FireSolution& solution : solutions) {
        const Vec2 direction = directionOf(solution.aim);
        const PointMotion launch{task.gunner + muzzleFrom(direction), speedOf(solution.aim.charge) * direction};
        for (double t = 0; t < solution.time; t += 0.01) {
            const Vec2 at = moveWithDrag(launch, {dragRate, {task.wind, 0}, {0, -gravity}}, t).position;
            if (std::abs(at.x()) < 2) REQUIRE(at.y() > 14);
        }
    }
}
