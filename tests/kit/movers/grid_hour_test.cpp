// SPDX-License-Identifier: MIT
// An hour of random input in random mazes: what no input may do to a grid mover.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

#include <plumb/math/random.h>
#include <plumb/movers/arcade_profile.h>

#include "cases.h"
#include "catch.h"
#include "kit/movers/mazes.h"

namespace {

using namespace plumb;
using namespace plumb::test;

/// Per tick, four numbers of at most 4 pixels, or of its way, are rounded per leg, and there are two legs a tile.
double roundingOf(double way) {
    return 8 * (1 + way) * 0x1p-52 * (2 * way + 2);
}

struct Totals {
    double seconds = 0, tiles = 0, worstWay = 0, worstSpan = 0;
    long ticks = 0, turns = 0, cut = 0, stops = 0, wraps = 0, reversals = 0;
};

Cornering randomCornering(Random& random) {
    const int kind = random.integer(0, 2);
    if (kind == 0) return {};
    if (kind == 1) return ArcadeProfile{}.cornering;
    const auto window = [&] { return CorneringWindow{random.uniform(0, 0.5), random.uniform(0, 0.5)}; };
    return {.up = window(), .left = window(), .down = window(), .right = window()};
}

bool hasWindows(const Cornering& cornering) {
    return cornering.up.before > 0;
}

/// One mover in one maze, watched by what knows nothing of how it moves.
class Walk {
public:
    Walk(Random& random, Totals& totals)
        : random_(random), totals_(totals), map_(randomMaze(random)), open_(map_), mover_(start()) {}

    /// What is wrong after another tick; nothing, if nothing is.
    std::string tick() {
        if (random_.integer(0, 9) < 3) mover_.want(static_cast<Direction>(random_.integer(0, 3)));
        if (random_.integer(0, 99) == 0) speed_ = random_.uniform(0, 30);
        if (random_.integer(0, 99) == 0) patterned_ = random_.integer(0, 1) == 0;
        if (random_.integer(0, 199) == 0) mover_.reverseOnEntry();
        cell_ = mover_.cell();
        heading_ = mover_.heading();
        offset_ = mover_.offset();
        const double dt = patterned_ ? 1 / 60.606061 : random_.uniform(0, 0.05);
        const SpeedPattern pattern = speedPattern(5 * random_.integer(1, 32));
        const int pixels = pattern.pixels(frames_);
        const auto events = patterned_ ? mover_.moveFrame(map_, pattern) : mover_.move(map_, speed_, dt);
        way_ = patterned_ ? pixels / 8.0 : speed_ * dt;
        if (patterned_) ++frames_;
        totals_.seconds += dt;
        ++totals_.ticks;
        return complaint(events);
    }

private:
    GridMover start() {
        Cell cell;
        do cell = {random_.integer(0, map_.columns() - 1), random_.integer(0, map_.rows() - 1)};
        while (!open_.at(cell));
        const Cornering cornering = randomCornering(random_);
        corners_ = hasWindows(cornering);
        return GridMover({.cell = cell,
                          .heading = static_cast<Direction>(random_.integer(0, 3)),
                          .cornering = cornering,
                          .reverses = random_.integer(0, 3) != 0});
    }

    std::string complaint(std::span<const GridEvent> events) {
        if (std::string wrong = whereItIs(); !wrong.empty()) return wrong;
        if (std::string wrong = whatItTold(events); !wrong.empty()) return wrong;
        if (std::string wrong = whyItStands(); !wrong.empty()) return wrong;
        return howFarItCame(events);
    }

    /// On a lane, or cutting a corner within its cell; in no wall, and leaning towards none.
    std::string whereItIs() const {
        const Vec2 offset = mover_.offset();
        const double x = std::fabs(offset.x()), y = std::fabs(offset.y());
        if (!open_.at(mover_.cell())) return "in a wall";
        if (!corners_ && x != 0 && y != 0) return "off its lane";
        if (x + y > 0.5 + 4 * 0x1p-52) return "out of its cell's middle";
        for (const Direction side : allDirections)
            if (offset.dot(unitOf(side)) > 0 && !open_.ahead(mover_.cell(), side)) return "leaning into a wall";
        return {};
    }

    /// Its events, walked along cell by cell, lead from where it was to where it is.
    std::string whatItTold(std::span<const GridEvent> events) {
        Cell cell = cell_;
        Direction heading = heading_;
        bool wrapped = false;
        for (const GridEvent& event : events) {
            const Cell next = open_.next(cell, heading), inside = open_.wrapped(next);
            const bool turns = event.kind == GridEventKind::Turned || event.kind == GridEventKind::Reversed;
            if (event.kind == GridEventKind::Wrapped) {
                ++totals_.wraps;
                if (inside == next) return "wrapped where there is no edge";
                wrapped = true;
            }
            if (event.kind == GridEventKind::Entered) {
                if (wrapped != !(inside == next)) return "over an edge without a word";
                if (!open_.at(next)) return "through a wall";
                wrapped = false;
            }
            if (event.kind == GridEventKind::Wrapped || event.kind == GridEventKind::Entered) cell = inside;
            if (event.kind == GridEventKind::Wrapped) cell = beforeEdge(inside, heading);
            if (turns && isHorizontal(event.direction) == isHorizontal(heading) && event.kind == GridEventKind::Turned)
                return "turned into its own lane";
            if (event.kind == GridEventKind::Reversed && unitOf(event.direction) != Vec2(-unitOf(heading)))
                return "reversed, but not back";
            if (event.kind == GridEventKind::Turned && !open_.ahead(cell, event.direction))
                return "turned towards a wall";
            if (turns) heading = event.direction;
            if (!(event.cell == (event.kind == GridEventKind::Wrapped ? inside : cell)))
                return "an event of another cell";
            if (event.direction != heading) return "an event of another direction";
            totals_.turns += event.kind == GridEventKind::Turned ? 1 : 0;
            totals_.reversals += event.kind == GridEventKind::Reversed ? 1 : 0;
            totals_.stops += event.kind == GridEventKind::Stopped ? 1 : 0;
        }
        if (!(cell == mover_.cell()) || heading != mover_.heading()) return "its events lead elsewhere";
        return {};
    }

    Cell beforeEdge(Cell inside, Direction heading) const {
        return open_.wrapped(open_.next(inside, opposite(heading)));
    }

    /// Only at the centre, before a wall, with no open way wanted.
    std::string whyItStands() const {
        if (!mover_.stopped()) return {};
        if (mover_.offset() != Vec2(0, 0)) return "stopped beside the centre";
        if (open_.ahead(mover_.cell(), mover_.heading())) return "stopped before an open way";
        const auto wanted = mover_.wanted();
        if (way_ == 0 || !wanted || !open_.ahead(mover_.cell(), *wanted)) return {};
        int exits = 0;
        for (const Direction exit : allDirections) exits += open_.ahead(mover_.cell(), exit) ? 1 : 0;
        const bool back = unitOf(*wanted) == Vec2(-unitOf(mover_.heading()));
        return back && exits > 1 && !mover_.def().reverses ? "" : "stuck, though the way it wants is open";
    }

    /// Along the heading, between centres and edges, its way is speed times time.
    std::string howFarItCame(std::span<const GridEvent> events) {
        const Vec2 offset = mover_.offset();
        const bool cutting = offset.x() != 0 && offset.y() != 0;
        totals_.cut += cutting ? 1 : 0;
        if (mover_.stopped()) return {};
        totals_.tiles += way_;
        if (events.empty()) {  // in one cell, in one direction: the larger of both axes
            const double span = (offset - offset_).cwiseAbs().maxCoeff();
            totals_.worstSpan = std::max(totals_.worstSpan, std::fabs(span - way_));
            return std::fabs(span - way_) <= roundingOf(way_) ? "" : "not as far as its speed times time";
        }
        if (corners_) return {};
        const double came = cameOnLanes(events);
        totals_.worstWay = std::max(totals_.worstWay, std::fabs(came - way_));
        return std::fabs(came - way_) <= roundingOf(way_) ? "" : "not as far as its speed times time, over centres";
    }

    /// In frames it turns back between two pixels, or at a centre if the way back from there is open.
    double toWhereItTurnedBack(const GridEvent& event, double from, double sum) const {
        const bool backOpen = open_.ahead(event.cell, event.direction);
        if (from == 0 && backOpen) return 0;
        const double toPixel = std::ceil(sum * 8 - 1e-9) / 8 - sum;  // 1e-9: whole, to rounding
        // The left and lower edges of a cell are not its own: it is in there only after the next pixel.
        const bool behindEdge = from == -0.5 && !isForward(event.direction);
        return (from == 0 || behindEdge) && toPixel < 1e-9 ? 0.125 : toPixel;
    }

    /// Without windows every event has its place: edges, centres, and where the last one was.
    double cameOnLanes(std::span<const GridEvent> events) const {
        double sum = 0, from = offset_.dot(unitOf(heading_));
        for (const GridEvent& event : events) {
            switch (event.kind) {
                case GridEventKind::Entered:
                    sum += 0.5 - from;
                    from = -0.5;
                    break;
                case GridEventKind::ReachedCentre:
                case GridEventKind::Turned:
                    sum += 0 - from;
                    from = 0;
                    break;
                case GridEventKind::Reversed:
                    if (patterned_) {
                        const double rest = toWhereItTurnedBack(event, from, sum);
                        sum += rest;
                        from += rest;
                    }
                    from = -from;
                    break;
                case GridEventKind::Stopped:
                case GridEventKind::Wrapped: break;
            }
        }
        return sum + mover_.offset().dot(unitOf(mover_.heading())) - from;
    }

    Random& random_;
    Totals& totals_;
    TileMap map_;
    OpenCells open_;
    bool corners_ = false, patterned_ = false;
    GridMover mover_;
    double speed_ = 8, way_ = 0;
    std::uint32_t frames_ = 0;
    Cell cell_;
    Direction heading_ = Direction::Right;
    Vec2 offset_{0, 0};
};

}  // namespace

TEST_CASE("one hour of random input in 60 mazes: never off a lane, through a wall, stuck where a way is open, or short",
          "[movers][arcade]") {
    Totals totals;
    const int hours = cases(10);
    for (int maze = 0; maze < 60 * hours; ++maze) {
        Random random(static_cast<std::uint64_t>(maze) + 1);
        Walk walk(random, totals);
        const double end = totals.seconds + 60;
        for (int tick = 0; totals.seconds < end; ++tick) {
            const std::string complaint = walk.tick();
            CAPTURE(maze, tick);
            REQUIRE(complaint == "");
        }
    }
    CHECK(totals.turns > 1000 * hours);
    CHECK(totals.cut > 1000 * hours);
    CHECK(totals.stops > 1000 * hours);
    CHECK(totals.wraps > 1000 * hours);
    CHECK(totals.reversals > 1000 * hours);
    std::cout << hours << " h in mazes: " << totals.ticks << " ticks, " << totals.tiles << " tiles, " << totals.turns
              << " turns, " << totals.cut << " ticks in corners, " << totals.stops << " stops, " << totals.wraps
              << " wraps, " << totals.reversals << " reversals; way off speed x time a tick: at most "
              << totals.worstSpan << " tiles within a cell, " << totals.worstWay << " over centres\n";
}
