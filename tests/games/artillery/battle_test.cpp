// SPDX-License-Identifier: MIT
#include <games/artillery/battle.h>

#include <plumb/kinematics/linear_drag.h>
#include <plumb/math/random.h>
#include <algorithm>

#include "cases.h"
#include "catch.h"
#include "games/artillery/played.h"

using namespace plumb;
using namespace plumb::games::artillery;
using namespace plumb::games::artillery::test;

namespace {

/// Turns the barrel and charges at random, up to the tick before the shell is fired.
void aimAnyhow(Battle& battle, Random& random) {
    const bool up = random.integer(0, 1) == 0;
    for (int i = random.integer(5, 40); i > 0; --i) battle.update({.up = up, .down = !up});
    const int charge = random.integer(20, 99);
    do battle.update({.fire = true});
    while (battle.gunner().aim.charge < charge);
}

}  // namespace

TEST_CASE("the shell follows the aim line to the last bit, in 200 shots on 200 islands", "[games][artillery]") {
    const int shots = plumb::test::cases(200);
    int flown = 0;  // shots that do not end at a nearby crate
    for (int seed = 1; seed <= shots; ++seed) {
        Battle battle({.seed = static_cast<std::uint64_t>(seed), .wind = 14});
        Random random(static_cast<std::uint64_t>(seed));
        waitToAim(battle);
        aimAnyhow(battle, random);
        const Forecast path = battle.forecastOf(battle.gunner().aim, battle.gunner().weapon, 600);
        battle.update({});  // releases fire
        std::size_t tick = 1;
        for (; battle.shell(); battle.update({}), ++tick) {
            const Transform pose = battle.world().body(battle.shell()->body).pose();
            CAPTURE(seed, tick);
            REQUIRE(pose.position == path.poses[tick].position);
            REQUIRE(pose.rotation.cos == path.poses[tick].rotation.cos);
        }
        flown += tick > 30;
        // The shell explodes where the line ends.
        for (const Happening& happening : battle.takeHappenings())
            if (happening.kind == Happening::Kind::Exploded && !path.hits.empty() &&
                path.hits.front().tick == static_cast<int>(tick))
                REQUIRE(happening.at == path.poses[tick].position);
    }
    REQUIRE(flown > shots / 2);
}

TEST_CASE("in the air a shell follows the closed form of linear drag and wind", "[games][artillery]") {
    Battle battle({.seed = 3, .wind = 14}, Terrain(2.0), {-25, 25});
    waitToAim(battle);
    for (int i = 0; i < 60; ++i) battle.update({.fire = true});
    const Vec2 direction = directionOf(battle.gunner().aim);
    const PointMotion launch{battle.middleOf(battle.gunner()) + muzzleFrom(direction),
                             speedOf(battle.gunner().aim.charge) * direction};
    const DragLaw law{dragRate, {battle.wind(), 0}, {0, -gravity}};
    for (int tick = 1; tick <= 120; ++tick) {
        battle.update({});
        REQUIRE(battle.shell());
        const Vec2 at = battle.world().body(battle.shell()->body).position();
        // 120 steps, each rounded to 1e-16 of about 30 m, and their sums.
        REQUIRE((at - moveWithDrag(launch, law, tick / 60.0).position).norm() < 1e-10);
    }
}

TEST_CASE("no building on 100 islands moves before the first shot, and nobody is hurt", "[games][artillery]") {
    for (int seed = 1; seed <= plumb::test::cases(100); ++seed) {
        Battle battle({.seed = static_cast<std::uint64_t>(seed)});
        std::vector<Vec2> first;
        for (const Prop& prop : battle.props()) first.push_back(battle.world().body(prop.body).position());
        for (int tick = 0; tick < 300; ++tick) battle.update({});
        REQUIRE(battle.props().size() == first.size());
        for (std::size_t i = 0; i < first.size(); ++i) {
            CAPTURE(seed, i, first[i].x());
            REQUIRE((battle.world().body(battle.props()[i].body).position() - first[i]).norm() < 0.1);
        }
        for (const int crew : {0, 1}) REQUIRE(battle.healthOf(crew) == gunnersEach * fullHealth);
    }
}

TEST_CASE("a shell that explodes at a gunner's feet hurts and throws the gunner, and makes a crater below",
          "[games][artillery]") {
    Battle battle({.seed = 1, .wind = 0}, Terrain(3.0), {-12, 12});
    const FirstShot shot = firstShot(battle, unerring);
    const int enemy = 1 - battle.crew();
    REQUIRE(shot.miss < 1);
    // The damage is 60 (1 - d / 3.6), and d <= 1.
    REQUIRE(battle.healthOf(enemy) <= 100 - 43);
    double lowest = 3;
    for (double x = shot.at.x() - 1; x < shot.at.x() + 1; x += 0.1)
        lowest = std::min(lowest, battle.terrain().heightAt(x));
    REQUIRE(lowest < 3 - 0.5);
    double highest = 0;
    for (int tick = 0; tick < 60; ++tick) {
        battle.update({});
        for (const Gunner& gunner : battle.gunners())
            if (gunner.crew == enemy) highest = std::max(highest, battle.middleOf(gunner).y());
    }
    REQUIRE(highest > 3 + gunnerHalf + 0.3);
}

TEST_CASE("a turn without orders ends after 25 s, and the other crew's turn begins with another wind",
          "[games][artillery]") {
    Battle battle({.seed = 5, .wind = 10}, Terrain(3.0), {-12, 12});
    const int first = battle.crew();
    const double wind = battle.wind();
    waitToAim(battle);
    int ticks = 0;
    for (; battle.phase() == Phase::Aim; ++ticks) battle.update({});
    REQUIRE(ticks == turnTicks);
    while (battle.phase() == Phase::Settle) battle.update({});
    REQUIRE(battle.crew() == 1 - first);
    REQUIRE(battle.wind() != wind);
}

TEST_CASE("a turn reports each of its last 5 s, and a shell reports its fall once, however often it bounces",
          "[games][artillery]") {
    Battle battle({.seed = 5, .wind = 0}, Terrain(3.0), {-12, 12});
    waitToAim(battle);
    while (battle.phase() == Phase::Aim) battle.update({});
    const auto countOf = [&](Happening::Kind kind) {
        const std::vector<Happening> all = battle.takeHappenings();
        return std::count_if(all.begin(), all.end(), [kind](const Happening& one) { return one.kind == kind; });
    };
    REQUIRE(countOf(Happening::Kind::Hurry) == 5);
    waitToAim(battle);
    battle.update({.weapon = true});
    REQUIRE(weapons[static_cast<std::size_t>(battle.gunner().weapon)].fuse > 0);
    for (int i = 0; i < 30; ++i) battle.update({.fire = true});
    battle.takeHappenings();
    while (battle.phase() != Phase::Settle) battle.update({});
    REQUIRE(countOf(Happening::Kind::Falling) == 1);
}

TEST_CASE("from the tide's turn on, the sea rises every turn until the battle is over", "[games][artillery]") {
    Battle battle({.seed = 5, .wind = 10, .tideTurn = 2}, Terrain(3.0), {-12, 12});
    int ticks = 0;
    for (; battle.phase() != Phase::Over && ticks < 100'000; ++ticks) battle.update({});
    REQUIRE(battle.phase() == Phase::Over);
    // Both gunners' centres are 0.9 m above the ground at 3 m: the sea reaches them after 8 turns of 0.55 m.
    REQUIRE(battle.turn() == 9);
    REQUIRE(battle.winner() == -1);
}
