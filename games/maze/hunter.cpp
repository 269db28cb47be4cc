// SPDX-License-Identifier: MIT
#include <games/maze/hunter.h>

#include <games/maze/level_rules.h>
#include <plumb/movers/grid_choice.h>

namespace plumb::games::maze {
namespace {

GridMover moverBeforeDoor(Direction heading) {
    const GridPlace& place = specialPlaces().starts[indexOf(Who::Chaser)];
    return GridMover({.cell = place.cell, .offset = place.offset, .heading = heading, .reverses = false});
}

bool isBeyondDoorstep(const Vec2& position, const Vec2& before) {
    const Vec2 step = tilesOf(doorstep());
    return position.y() == step.y() && (position.x() - step.x()) * (before.x() - step.x()) <= 0;
}

}  // namespace

Hunter::Hunter(Who who)
    : who_(who),
      where_(who == Who::Chaser ? Where::Lanes : Where::Home),
      walk_(who, homeOf(who)),
      mover_(moverBeforeDoor(Direction::Left)) {
    if (who == Who::Chaser) beginLanes();
}

void Hunter::step(const Sight& sight, SpeedPattern speed, Random& random) {
    switch (where_) {
        case Where::Home: return walk_.bob(patternOf(houseSpeed));
        case Where::Leaving:
            if (!walk_.leave(patternOf(houseSpeed))) return;
            beginLanes();
            return decide(mover_.cell(), sight, random);
        case Where::Lanes: return run(sight, speed, random);
        case Where::Eyes: {
            const Vec2 before = position();
            run(sight, patternOf(eyesSpeed), random);
            if (!isBeyondDoorstep(position(), before)) return;
            where_ = Where::Entering;
            walk_ = HouseWalk(who_, doorstep());
            return;
        }
        case Where::Entering:
            if (walk_.enter(patternOf(eyesSpeed))) where_ = Where::Leaving;
    }
}

/// A hunter plans one tile ahead: when it enters a cell, it has already chosen the exit of that cell, and now chooses
/// the exit of the next one. A hunter that turns back may enter one more cell in the same frame: each choice uses the
/// cell of its event.
void Hunter::run(const Sight& sight, SpeedPattern speed, Random& random) {
    for (const GridEvent& event : mover_.moveFrame(mazeMap(), speed)) {
        if (event.kind == GridEventKind::Entered) {
            exit_ = plan_;
            mover_.want(exit_);
            decide(event.cell, sight, random);
        } else if (event.kind == GridEventKind::Reversed) {
            mover_.wantNothing();  // its plan was for the old heading
            exit_ = event.direction;
            decide(event.cell, sight, random);
        }
    }
}

void Hunter::decide(Cell from, const Sight& sight, Random& random) {
    const TileMap& map = mazeMap();
    const Cell next = map.wrapped(neighbourOf(from, exit_));
    const bool hunts = where_ == Where::Lanes && !frightened_;
    const GridCrossing crossing{
        .cell = next, .heading = exit_, .upClosed = hunts && isUpClosed(specialPlaces(), next, false)};
    const std::optional<Direction> chosen =
        frightened_ ? firstOpenClockwise(map, crossing, static_cast<Direction>(random.integer(0, 3)))
                    : nextDirection(map, crossing, targetFrom(from, sight));
    plan_ = chosen.value_or(opposite(exit_));
}

Cell Hunter::targetFrom(Cell from, const Sight& sight) const {
    if (where_ == Where::Eyes) return specialPlaces().door;
    if (sight.rests) return scatterTarget(who_);
    return chaseTarget(who_, {from, sight.player, sight.heading, sight.chaser});
}

void Hunter::beginLanes() {
    const Direction heading = leavesRight_ ? Direction::Right : Direction::Left;
    leavesRight_ = false;
    where_ = Where::Lanes;
    mover_ = moverBeforeDoor(heading);
    exit_ = plan_ = heading;  // before the door there is no other exit
}

void Hunter::turnBack() {
    if (where_ == Where::Lanes)
        mover_.reverseOnEntry();
    else if (where_ != Where::Eyes)
        leavesRight_ = true;
}

void Hunter::beCaught() {
    where_ = Where::Eyes;
    frightened_ = false;
}

Direction Hunter::heading() const {
    return isInLanes() ? mover_.heading() : walk_.looks();
}

Vec2 Hunter::position() const {
    return isInLanes() ? mover_.position(mazeMap()) : tilesOf(walk_.at());
}

void Hunter::addTo(Hash& hash) const {
    const Vec2 at = position();
    hash.add(static_cast<int>(where_)).add(frightened_).add(leavesRight_).add(at.x()).add(at.y());
    hash.add(static_cast<int>(heading())).add(static_cast<int>(plan_)).add(std::uint64_t{walk_.frame()});
}

}  // namespace plumb::games::maze
