// SPDX-License-Identifier: MIT
// Source of all speeds: The Pac-Man Dossier, its table.
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "catch.h"
#include "games/maze/driven.h"

namespace {

using namespace plumb;
using namespace plumb::games::maze;

/// In percent of 1.25 pixels a frame; 0: the level has none. dots: the player's mean speed while it eats dots and
/// pauses for each.
struct Row {
    int level, player, dots, playerFright, hunter, hunterFright, tunnel, haste1, haste2;
    int hasteDots;  ///< dots left when haste1 begins; half as many for haste2
};
const Row table[]{{1, 80, 71, 90, 75, 50, 40, 80, 85, 20},
                  {2, 90, 79, 95, 85, 55, 45, 90, 95, 30},
                  {5, 100, 87, 100, 95, 60, 50, 100, 105, 40},
                  {21, 90, 79, 0, 95, 0, 50, 100, 105, 120}};

/// Patterns repeat after 16 frames; in these, p % is exactly p / 5 pixels.
constexpr int window = 16;

/// How far something moved while its kind stayed the same.
class Walk {
public:
    /// The pixels of the last 16 frames if all of them were of this kind, else -1.
    int add(const std::string& kind, const Vec2& position) {
        const Vec2 step = (position - last_) * 8;
        last_ = position;
        if (kind != kind_ || kind.empty()) {
            kind_ = kind;
            ways_.clear();
            return -1;
        }
        ways_.push_back(std::fabs(step.x()) + std::fabs(step.y()));
        if (ways_.back() > 100) ways_.back() -= 8 * 28;  // through the tunnel
        if (static_cast<int>(ways_.size()) < window) return -1;
        double sum = 0;
        for (int i = 0; i < window; ++i) sum += std::fabs(ways_[ways_.size() - 1 - static_cast<std::size_t>(i)]);
        return static_cast<int>(std::lround(sum));
    }

private:
    std::string kind_;
    Vec2 last_{0, 0};
    std::vector<double> ways_;
};

/// The column of the table that holds for a hunter, from its cell, its fright and the dots left; "" if not certain.
std::string kindOf(const Chase& chase, const Row& row, Who who, bool loneHasLeft) {
    const Hunter& hunter = chase.hunter(who);
    if (hunter.where() != Where::Lanes) return "";
    const Cell cell = hunter.cell();
    if (35 - cell.row == 17 && (cell.column <= 5 || cell.column >= 22)) return "tunnel";
    if (hunter.frightened()) return "fright";
    if (who != Who::Chaser || chase.dotsLeft() > row.hasteDots) return "hunter";
    if (!loneHasLeft) return "";
    return chase.dotsLeft() > row.hasteDots / 2 ? "haste1" : "haste2";
}

}  // namespace

TEST_CASE("the chaser speeds up at 20, 30, 40, 50, 60, 80, 100 and 120 dots left, and again at half as many",
          "[games][maze]") {
    const std::vector<int> dots{20, 30, 40, 40, 40, 50, 50, 50, 60, 60, 60, 80, 80, 80, 100, 100, 100, 100, 120, 120};
    for (std::size_t i = 0; i < dots.size(); ++i) CHECK(rulesOf(static_cast<int>(i) + 1).hasteDots == dots[i]);
}

TEST_CASE("hunters run at the table's speeds on levels 1, 2, 5 and 21: p / 5 pixels in any 16 frames",
          "[games][maze][slow]") {
    for (const Row& row : table) {
        const std::map<std::string, int> percent{{"hunter", row.hunter},
                                                 {"fright", row.hunterFright},
                                                 {"tunnel", row.tunnel},
                                                 {"haste1", row.haste1},
                                                 {"haste2", row.haste2}};
        std::map<std::string, int> seen;
        test::DrivenChase driven(row.level);
        std::array<Walk, 4> walks;
        std::array<Direction, 4> headings{};
        bool loneHasLeft = true;
        for (int frame = 0; frame < 14'000; ++frame) {
            const bool stands = driven.chase().frozen();
            driven.step();
            const Chase& chase = driven.chase();
            if (chase.playerCaught())
                loneHasLeft = false;
            else if (chase.cleared() || chase.hunter(Who::Loner).where() == Where::Lanes)
                loneHasLeft = true;
            // In the frame in which its kind changes, a hunter still has its old speed. Such windows are left out.
            for (const Who who : everyone) {
                const bool plain = !stands && !chase.frozen() && !chase.playerCaught() && !chase.cleared();
                const Direction heading = chase.hunter(who).heading();
                const Direction before = std::exchange(headings[indexOf(who)], heading);
                const bool onward = heading != opposite(before);  // else a part of its way is forward and back
                const std::string kind = plain && onward ? kindOf(chase, row, who, loneHasLeft) : "";
                const int way = walks[indexOf(who)].add(kind, chase.hunter(who).position());
                if (way < 0) continue;
                ++seen[kind];
                CAPTURE(row.level, kind, frame, indexOf(who));
                REQUIRE(way == percent.at(kind) / 5);
            }
        }
        CAPTURE(row.level, seen["hunter"], seen["fright"], seen["tunnel"], seen["haste1"], seen["haste2"]);
        CHECK(seen["hunter"] > 1000);
        CHECK((row.hunterFright == 0 ? seen["fright"] == 0 : seen["fright"] > 100));
        CHECK(seen["tunnel"] > 50);
        CHECK(seen["haste1"] + seen["haste2"] > 50);
    }
}

TEST_CASE("where there are no dots, the player runs at 80, 90, 100 and 90 %, in fright at 90, 95 and 100 %",
          "[games][maze]") {
    for (const Row& row : table) {
        std::map<std::string, int> seen;
        test::DrivenChase driven(row.level);
        Walk walk;
        Direction heading = Direction::Left;
        int sinceEaten = 0;
        for (int frame = 0; frame < 6'000; ++frame) {
            const bool stands = driven.chase().frozen();
            driven.step();
            const Chase& chase = driven.chase();
            sinceEaten = chase.events().empty() ? sinceEaten + 1 : 0;
            const bool straight = chase.player().heading() == heading && !chase.player().stopped();
            heading = chase.player().heading();
            const bool plain = !stands && sinceEaten > 3 && straight && !chase.playerCaught() && !chase.cleared();
            const std::string kind = !plain ? "" : chase.frightFrames() > 0 ? "fright" : "player";
            const bool aside = (isHorizontal(heading) ? chase.player().offset().y() : chase.player().offset().x()) != 0;
            const int way = walk.add(aside ? "" : kind, chase.playerPosition());
            if (way < 0) continue;
            ++seen[kind];
            CAPTURE(row.level, kind, frame);
            REQUIRE(way == (kind == "fright" ? row.playerFright : row.player) / 5);
        }
        CHECK(seen["player"] > 20);
        CHECK((row.playerFright == 0 ? seen["fright"] == 0 : seen["fright"] > 5));
    }
}

// 64 pixels take 64 / (1.25 p) frames, and 8 frames of pauses. One frame is 1.7 % of this time.
TEST_CASE("eating dots lowers the player's speed to 71, 79, 87 and 79 %: it pauses one frame for each",
          "[games][maze]") {
    for (const Row& row : table) {
        Chase chase(row.level);
        int frames = 0, counted = 0;
        for (int dots = 0; dots < 9; ++frames) {
            chase.step(Direction::Left);
            for (const ChaseEvent& event : chase.events()) {
                REQUIRE(event.kind == Happening::Dot);
                if (++dots == 1) counted = frames;
            }
            REQUIRE(frames < 200);
        }
        const double percent = 100 * 64 / 1.25 / (frames - 1 - counted);
        CAPTURE(row.level, percent);
        CHECK(std::fabs(percent - row.dots) < 0.5 + 0.017 * row.dots);
    }
}

TEST_CASE("a dot pauses the player for 1 frame, a power dot for 3, they give 10 and 50 points", "[games][maze]") {
    test::DrivenChase driven(1);
    const Chase& chase = driven.chase();
    int dots = 0, powers = 0, held = 0;
    Vec2 place{0, 0};
    for (int frame = 0; frame < 6'000; ++frame) {
        const bool frozen = chase.frozen();
        driven.step();
        if (held > 0 && !frozen) {
            --held;
            CHECK(chase.playerPosition() == place);
        }
        for (const ChaseEvent& event : chase.events()) {
            const bool power = event.kind == Happening::Power;
            if (!power && event.kind != Happening::Dot) continue;
            CHECK(event.points == (power ? 50 : 10));
            held = power ? 3 : 1;
            place = chase.playerPosition();
            ++(power ? powers : dots);
        }
        if (chase.playerCaught() || chase.cleared()) held = 0;
    }
    CHECK(dots > 200);
    CHECK(powers >= 4);
}
