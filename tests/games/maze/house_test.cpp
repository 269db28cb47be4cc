// SPDX-License-Identifier: MIT
// Source of all limits: The Pac-Man Dossier, chapter 2.
#include <games/maze/house_counters.h>

#include "catch.h"

namespace {

using namespace plumb;
using namespace plumb::games::maze;

/// A house with waiting hunters, in which a test can eat dots and let frames pass.
struct House {
    explicit House(int level) : rules(rulesOf(level)) {}

    std::optional<Who> frame() {
        const std::optional<Who> left = counters.next(waiting, rules);
        if (left) waiting[indexOf(*left)] = false;
        return left;
    }
    /// Eats one dot a frame until this hunter leaves. Returns how many were eaten, or -1 if it needs more than most.
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

TEST_CASE("only the first waiting hunter counts dots, and it keeps its count after a death", "[games][maze]") {
    House house(1);
    CHECK(house.dotsUntil(Who::Ambusher) == 0);
    for (int i = 0; i < 12; ++i) house.counters.dotEaten(house.waiting);
    CHECK(house.counters.dotsOf(Who::Flanker) == 12);
    CHECK(house.counters.dotsOf(Who::Loner) == 0);
    house.counters.beginLifeAfterDeath();
    CHECK(house.counters.dotsOf(Who::Flanker) == 12);
}

TEST_CASE("after a death one shared counter lets hunters out at 7 and 17, at 32 the loner's own counter takes over",
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
    CHECK(house.dotsUntil(Who::Loner) == 60);  // its own counter was at 0
}

TEST_CASE("the shared counter is not turned off at 32 if the loner is not at home", "[games][maze]") {
    House house(1);
    house.counters.beginLifeAfterDeath();
    house.waiting = {};
    for (int i = 0; i < 40; ++i) house.counters.dotEaten(house.waiting);
    CHECK(house.counters.countsForAll());
    CHECK(house.counters.dotsForAll() == 40);
    house.waiting[indexOf(Who::Ambusher)] = true;
    CHECK_FALSE(house.frame());  // its limit of 7 was passed long before
}

TEST_CASE("if no dot is eaten, a hunter leaves every 240 frames, 4 s, and from level 5 on every 180 frames, 3 s",
          "[games][maze]") {
    for (const int level : {1, 2, 4, 5, 21}) {
        House house(level);
        house.counters.beginLifeAfterDeath();  // otherwise they leave at once on later levels
        const int frames = level < 5 ? 240 : 180;
        for (int i = 0; i < 3; ++i) CHECK(house.framesUntilSomeoneLeaves() == frames);
        CHECK(house.framesUntilSomeoneLeaves() == -1);
    }
    House house(1);
    house.counters.beginLifeAfterDeath();
    for (int i = 0; i < 239; ++i) CHECK_FALSE(house.frame());
    house.counters.dotEaten(house.waiting);  // the time starts again
    CHECK(house.framesUntilSomeoneLeaves() == 240);
}
