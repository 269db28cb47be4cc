// SPDX-License-Identifier: MIT
// Source of all rules: The Pac-Man Dossier, chapters 3 and 4.
#include <algorithm>
#include <tuple>
#include <utility>

#include <games/maze/lanes.h>

#include "catch.h"
#include "games/maze/book.h"
#include "games/maze/driven.h"

namespace {

using namespace plumb;
using namespace plumb::games::maze;
using namespace plumb::test;

Cell cellAfter(Cell cell, Direction exit) {
    return mazeMap().wrapped(neighbourOf(cell, exit));
}

int tilesBetween(Cell a, Cell b) {
    return lanes().distance(a, b);
}

bool has(std::span<const ChaseEvent> events, Happening kind) {
    return std::any_of(events.begin(), events.end(), [&](const ChaseEvent& event) { return event.kind == kind; });
}

/// The state of a hunter, to compare it with the next frame.
struct Seen {
    bool hunts = false, inLanes = false;
    Cell cell;
    Direction heading, plan;
};
Seen seenOf(const Hunter& hunter) {
    const bool inLanes = hunter.where() == Where::Lanes;
    return {inLanes && !hunter.frightened(), inLanes, hunter.cell(), hunter.heading(), hunter.plan()};
}

/// A hunter's plan according to the source, made in a cell that it leaves by a given exit.
struct Plan {
    const Chase& chase;
    Who who;
    bool rests;

    Direction madeIn(Cell cell, Direction exit) const {
        return exitByTheBook(cellAfter(cell, exit), exit, targetByTheBook(chase, who, cell, rests));
    }
};

}  // namespace

TEST_CASE("in 30,000 frames each hunter's target is the source's, with the bug upward and both targets of the loner",
          "[games][maze]") {
    test::DrivenChase driven(1);
    const Chase& chase = driven.chase();
    int upward = 0, shy = 0, bold = 0, resting = 0, restless = 0;
    for (int frame = 0; frame < 30'000; ++frame) {
        driven.step();
        const bool scatter = chase.mode() == HunterMode::Scatter;
        for (const Who who : everyone) {
            const Hunter& hunter = chase.hunter(who);
            if (hunter.where() != Where::Lanes) continue;
            const bool rests = scatter && !(who == Who::Chaser && chase.haste() > 0);
            const Spot want = targetByTheBook(chase, who, hunter.cell(), rests), got = spotOf(chase.targetOf(who));
            REQUIRE(std::tuple(want.column, want.row) == std::tuple(got.column, got.row));
            resting += rests ? 1 : 0;
            restless += scatter && !rests ? 1 : 0;
            upward += !rests && chase.player().heading() == Direction::Up ? 1 : 0;
            if (who == Who::Loner && !rests) ++(got.column == 0 && got.row == 35 ? shy : bold);
        }
    }
    CHECK(upward > 500);
    CHECK(shy > 100);
    CHECK(bold > 100);
    CHECK(resting > 500);
    CHECK(restless > 50);  // the hasty chaser hunts while the others rest
}

TEST_CASE("a hunter that enters a cell plans the exit of the next one as the source says, also after turning back",
          "[games][maze]") {
    test::DrivenChase driven(1);
    const Chase& chase = driven.chase();
    int plans = 0, reversals = 0;
    std::array<Seen, 4> seen;
    for (int frame = 0; frame < 30'000; ++frame) {
        if (chase.playerCaught() || chase.cleared()) seen = {};
        const bool scatter = chase.mode() == HunterMode::Scatter;  // the mode changes after all moves
        driven.step();
        for (const Who who : everyone) {
            const Hunter& hunter = chase.hunter(who);
            const Seen before = std::exchange(seen[indexOf(who)], seenOf(hunter));
            if (!before.hunts || !seen[indexOf(who)].hunts) continue;
            CAPTURE(frame, indexOf(who), hunter.cell().column, hunter.cell().row);
            const bool rests = scatter && !(who == Who::Chaser && chase.haste() > 0);
            const Plan plan{chase, who, rests};
            if (hunter.heading() == opposite(before.heading)) {
                // It entered a cell by one pixel, turned back, and left that cell again in one frame.
                const Cell behind = cellAfter(hunter.cell(), before.heading);
                const Direction exit = plan.madeIn(behind, hunter.heading());
                REQUIRE(hunter.plan() == plan.madeIn(hunter.cell(), exit));
                ++reversals;
            } else if (!(hunter.cell() == before.cell)) {
                REQUIRE(hunter.plan() == plan.madeIn(hunter.cell(), before.plan));
                ++plans;
            } else {
                REQUIRE(hunter.plan() == before.plan);
            }
        }
    }
    CHECK(plans > 5'000);
    CHECK(reversals > 50);
}

TEST_CASE("level 1: at 7 s and at a power dot, every hunter in the lanes turns back when it enters the next cell",
          "[games][maze]") {
    test::DrivenChase driven(1);
    const Chase& chase = driven.chase();
    int turned = 0;
    std::array<std::optional<Cell>, 4> due;  // it must turn back in the cell after this one
    std::array<Seen, 4> seen;
    for (int frame = 0; frame < 30'000; ++frame) {
        if (chase.playerCaught() || chase.cleared()) due = {}, seen = {};
        const HunterMode mode = chase.mode();
        driven.step();
        const bool power = has(chase.events(), Happening::Power), change = chase.mode() != mode;
        for (const Who who : everyone) {
            const Hunter& hunter = chase.hunter(who);
            std::optional<Cell>& from = due[indexOf(who)];
            const Seen before = std::exchange(seen[indexOf(who)], seenOf(hunter));
            const bool inLanes = before.inLanes && hunter.where() == Where::Lanes;
            if (!inLanes) from.reset();
            if (inLanes && power && !from) from = before.cell;  // the dot is eaten before hunters move
            if (inLanes && hunter.heading() == opposite(before.heading)) {
                CAPTURE(frame, indexOf(who));
                REQUIRE(from);
                REQUIRE(hunter.cell() == *from);
                ++turned;
                from.reset();
            }
            if (from) REQUIRE(tilesBetween(hunter.cell(), *from) <= 1);
            if (inLanes && change && !from) from = hunter.cell();  // the clock runs after hunters move
        }
    }
    CHECK(turned > 50);
}

TEST_CASE("a frightened hunter moves at random: at least a third of its choices differ from those of a hunt",
          "[games][maze]") {
    test::DrivenChase driven(1);
    const Chase& chase = driven.chase();
    int choices = 0, strange = 0, upward = 0;
    std::array<Cell, 4> cells;
    for (int frame = 0; frame < 20'000; ++frame) {
        driven.step();
        for (const Who who : everyone) {
            const Hunter& hunter = chase.hunter(who);
            const Cell before = std::exchange(cells[indexOf(who)], hunter.cell());
            const bool entered = !(hunter.cell() == before);
            if (!hunter.frightened() || hunter.where() != Where::Lanes || !entered) continue;
            const Direction exit = hunter.heading();
            const Cell next = cellAfter(hunter.cell(), exit);
            if (lanes().exits(next).size() < 3) continue;
            upward += hunter.plan() == Direction::Up && isUpClosed(specialPlaces(), next, false) ? 1 : 0;
            ++choices;
            strange += hunter.plan() != Plan{chase, who, false}.madeIn(hunter.cell(), exit) ? 1 : 0;
        }
    }
    CHECK(choices > 100);
    CHECK(strange * 3 >= choices);
    CHECK(upward > 0);  // at cells that hunters otherwise do not leave upward
}

// The slowest speed of all tables, 40 %, is 8 pixels in 16 frames. They are spread evenly: a hunter stands still in 1
// frame of 2.
TEST_CASE("no hunter in the lanes ever stands still for 4 frames, in 20 chases of 3,000 frames",
          "[games][maze][slow]") {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        test::DrivenChase driven(seed % 2 == 0 ? 1 : 2, seed);
        const Chase& chase = driven.chase();
        std::array<Vec2, 4> places;
        std::array<int, 4> still{};
        for (int frame = 0; frame < 3'000; ++frame) {
            driven.step();
            for (const Who who : everyone) {
                const std::size_t i = indexOf(who);
                const Hunter& hunter = chase.hunter(who);
                const bool moves = hunter.isInLanes() && !chase.frozen() && !chase.playerCaught();
                still[i] = moves && hunter.position() == places[i] ? still[i] + 1 : 0;
                places[i] = hunter.position();
                CAPTURE(seed, frame, i, places[i].x(), places[i].y());
                REQUIRE(still[i] < 4);
            }
        }
    }
}

TEST_CASE("a hunter that was at home when the mode changed comes out to the right, the others to the left",
          "[games][maze]") {
    Chase chase(1);
    // The player runs left until a wall stops it, after 9 dots and about 80 frames. Then no dot is eaten: the flanker
    // leaves 240 frames later, the loner 240 after that. The mode changes at frame 420.
    std::array<bool, 4> out{true, false, false, false};
    std::array<Direction, 4> first{};
    for (int frame = 0; frame < 900 && !chase.playerCaught(); ++frame) {
        chase.step(std::nullopt);
        for (const Who who : everyone) {
            const bool inLanes = chase.hunter(who).where() == Where::Lanes;
            if (inLanes && !out[indexOf(who)]) first[indexOf(who)] = chase.hunter(who).heading();
            out[indexOf(who)] = out[indexOf(who)] || inLanes;
        }
    }
    CHECK(out[1]);
    CHECK(first[1] == Direction::Left);
    CHECK(out[2]);
    CHECK(first[2] == Direction::Left);
    CHECK(out[3]);
    CHECK(first[3] == Direction::Right);
}
