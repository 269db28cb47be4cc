// SPDX-License-Identifier: MIT
// Source of all limits: The Pac-Man Dossier, chapter 2.
#include <games/maze/house_counters.h>

#include "catch.h"

namespace {

using namespace plumb;
using namespace plumb::games::maze;

/// Hunters that wait in a house, dots that are eaten, frames that pass.
struct House {
    explicit House(int level) : rules(rulesOf(level)) {}

    std::optional<Who> frame() {
        const std::optional<Who> left = counters.next(waiting, rules);
        if (left) waiting[indexOf(*left)] = false;
        return left;
    }
    /// Eats until someone leaves, or so many; a frame after each. How many were eaten.
    int dotsUntil(Who who, int most = 300) {
        for (int eaten = 0; eaten <= most; ++eaten) {
            if (frame() == who) return eaten;
            counters.dotEaten(waiting);
        }
        return -1;
    }
    int framesUntilSomeoneLeaves() {
        for (int frames = 1; frames < 1000; ++frames)
            if (frame()) return frames;
        return -1;
    }

    LevelRules rules;
    HouseCounters counters;
    Waiting waiting{false, true, true, true};
};

}  // namespace

TEST_CASE("on level 1 the ambusher leaves at once, the flanker 30 dots later, the loner after 60 more",
          "[games][maze]") {
    House house(1);
    CHECK(house.dotsUntil(Who::Ambusher) == 0);
    CHECK(house.dotsUntil(Who::Flanker) == 30);
    CHECK(house.dotsUntil(Who::Loner) == 60);
    CHECK(house.counters.dotsOf(Who::Ambusher) == 0);
}

TEST_CASE("on level 2 the loner waits for 50 dots, from level 3 on nobody waits", "[games][maze]") {
    House second(2);
    CHECK(second.dotsUntil(Who::Ambusher) == 0);
    CHECK(second.dotsUntil(Who::Flanker) == 0);
    CHECK(second.dotsUntil(Who::Loner) == 50);
    for (const int level : {3, 5, 21}) {
        House house(level);
        CHECK(house.frame() == Who::Ambusher);
        CHECK(house.frame() == Who::Flanker);
        CHECK(house.frame() == Who::Loner);
        CHECK_FALSE(house.frame());
    }
}

TEST_CASE("only the first who waits counts dots, and what it counted outlives a death", "[games][maze]") {
    House house(1);
    CHECK(house.dotsUntil(Who::Ambusher) == 0);
    for (int i = 0; i < 12; ++i) house.counters.dotEaten(house.waiting);
    CHECK(house.counters.dotsOf(Who::Flanker) == 12);
    CHECK(house.counters.dotsOf(Who::Loner) == 0);
    house.counters.beginLifeAfterDeath();
    CHECK(house.counters.dotsOf(Who::Flanker) == 12);
}

TEST_CASE("after a death one counter lets them out at 7, at 17, and at 32 hands over to the loner's own",
          "[games][maze]") {
    House house(1);
    house.counters.beginLifeAfterDeath();
    CHECK(house.counters.countsForAll());
    CHECK(house.dotsUntil(Who::Ambusher) == 7);
    CHECK(house.dotsUntil(Who::Flanker) == 10);  // 17 in all
    for (int i = 18; i <= 32; ++i) {
        CHECK(house.counters.countsForAll());
        CHECK_FALSE(house.frame());
        house.counters.dotEaten(house.waiting);
    }
    CHECK_FALSE(house.counters.countsForAll());
    CHECK(house.dotsUntil(Who::Loner) == 60);  // it had counted none of its own
}

TEST_CASE("without the loner at home the counter for all is not turned off at 32", "[games][maze]") {
    House house(1);
    house.counters.beginLifeAfterDeath();
    house.waiting = {};
    for (int i = 0; i < 40; ++i) house.counters.dotEaten(house.waiting);
    CHECK(house.counters.countsForAll());
    CHECK(house.counters.dotsForAll() == 40);
    house.waiting[indexOf(Who::Ambusher)] = true;
    CHECK_FALSE(house.frame());  // its 7 are long past
}

TEST_CASE("without a dot one leaves every 240 frames, 4 s, and every 180, 3 s, from level 5 on", "[games][maze]") {
    for (const int level : {1, 2, 4, 5, 21}) {
        House house(level);
        house.counters.beginLifeAfterDeath();  // or they would leave at once on the later levels
        const int frames = level < 5 ? 240 : 180;
        for (int i = 0; i < 3; ++i) CHECK(house.framesUntilSomeoneLeaves() == frames);
        CHECK(house.framesUntilSomeoneLeaves() == -1);
    }
    House house(1);
    house.counters.beginLifeAfterDeath();
    for (int i = 0; i < 239; ++i) CHECK_FALSE(house.frame());
    house.counters.dotEaten(house.waiting);  // it begins anew
    CHECK(house.framesUntilSomeoneLeaves() == 240);
}
