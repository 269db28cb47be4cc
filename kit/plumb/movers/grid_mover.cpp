// SPDX-License-Identifier: MIT
#include <plumb/movers/grid_mover.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <plumb/math/check.h>

namespace plumb {

namespace {

constexpr int mostPixels = 1 << 20;
constexpr double mostTilesAtOnce = 1 << 20;
constexpr int mostFrames = 1 << 30;

void requireWindow(const CorneringWindow& window, const char* field) {
    requireWithin(window.before, 0, 0.5, field, ".before");
    requireWithin(window.after, 0, 0.5, field, ".after");
}

void requireSound(const Cornering& cornering) {
    requireWindow(cornering.up, "Cornering.up");
    requireWindow(cornering.left, "Cornering.left");
    requireWindow(cornering.down, "Cornering.down");
    requireWindow(cornering.right, "Cornering.right");
}

void requireDirection(Direction direction, const char* field) {
    const int value = static_cast<int>(direction);
    if (value > 3) refuse(field, std::to_string(value) + " is none of the four directions");
}

void requireOnLane(const GridMoverDef& def) {
    requireFinite(def.offset, "GridMoverDef.offset");
    const double along = isHorizontal(def.heading) ? def.offset.x() : def.offset.y();
    const double aside = isHorizontal(def.heading) ? def.offset.y() : def.offset.x();
    if (aside != 0 || !(along > -0.5 && along <= 0.5))
        refuse("GridMoverDef.offset", toText(def.offset) + " is not along the heading, above -1/2, to 1/2");
}

/// The part of a tick's way that is left when it stands for a while; that while grows shorter.
double withoutStanding(double way, double dt, double& standing) {
    const double stood = std::min(standing, dt);
    standing -= stood;
    return stood == dt ? 0 : way * ((dt - stood) / dt);
}

}  // namespace

const CorneringWindow& Cornering::of(Direction heading) const {
    switch (heading) {
        case Direction::Up: return up;
        case Direction::Left: return left;
        case Direction::Down: return down;
        case Direction::Right: break;
    }
    return right;
}

GridMover::GridMover(const GridMoverDef& def) : def_(def), cell_(def.cell), heading_(def.heading), halted_(def.halted) {
    requireDirection(def.heading, "GridMoverDef.heading");
    requireSound(def.cornering);
    requireOnLane(def);
    if (def.pixelsPerTile < 1 || def.pixelsPerTile > mostPixels)
        refuse("GridMoverDef.pixelsPerTile", std::to_string(def.pixelsPerTile) + " is not within 1 to 2^20");
    x_ = def.offset.x() * def.pixelsPerTile;
    y_ = def.offset.y() * def.pixelsPerTile;
}

void GridMover::want(Direction direction) {
    requireDirection(direction, "GridMover.want: direction");
    wanted_ = direction;
    halted_ = false;
}

void GridMover::setCornering(const Cornering& cornering) {
    requireSound(cornering);
    def_.cornering = cornering;
}

void GridMover::reverseOnEntry() {
    if (!reversing_) entered_ = false;  // the next entry, not the last
    reversing_ = true;
}

void GridMover::standFrames(int frames) {
    if (frames < 0 || frames > mostFrames - standingFrames_)
        refuse("GridMover.standFrames: frames", std::to_string(frames) + " is not within 0 to 2^30, all together");
    standingFrames_ += frames;
}

void GridMover::stand(double time) {
    requireNotNegative(time, "GridMover.stand: time");
    requireFinite(standing_ + time, "GridMover.stand: time");
    standing_ += time;
}

std::span<const GridEvent> GridMover::move(const TileMap& map, double speed, double dt) {
    requireNotNegative(speed, "GridMover.move: speed");
    requireNotNegative(dt, "GridMover.move: dt");
    requireWithin(speed * dt, 0, mostTilesAtOnce, "GridMover.move: speed dt");
    begin(map);
    go(map, withoutStanding(speed * dt * def_.pixelsPerTile, dt, standing_));
    return events_;
}

std::span<const GridEvent> GridMover::moveFrame(const TileMap& map, SpeedPattern speed) {
    begin(map);
    if (standingFrames_ > 0) {
        --standingFrames_;
        return events_;
    }
    for (int pixels = speed.pixels(frame_++); pixels > 0; --pixels) goPixel(map);
    return events_;
}

void GridMover::begin(const TileMap& map) {
    if (!map.contains(cell_))
        refuse("GridMover.cell", "(" + std::to_string(cell_.column) + ", " + std::to_string(cell_.row) +
                                     ") is not one of " + std::to_string(map.columns()) + " columns and " +
                                     std::to_string(map.rows()) + " rows");
    cell_ = map.wrapped(cell_);
    events_.clear();
}

void GridMover::go(const TileMap& map, double way) {
    while (way > 0) {
        turnBackIfEntered(map);
        obey(map);
        way -= goOn(map, way);
        crossIfDue(map, way > 0);
    }
}

/// Who is to turn back on entry has come a pixel into the cell by then.
void GridMover::goPixel(const TileMap& map) {
    turnBackIfEntered(map);
    for (double way = 1; way > 0;) {
        obey(map);
        way -= goOn(map, way);
        crossIfDue(map, way > 0);
    }
}

/// Turns, if that is wanted and can be here.
void GridMover::obey(const TileMap& map) {
    if (wanted_ == heading_) wanted_.reset();
    if (!wanted_) return;
    const bool back = *wanted_ == opposite(heading_);
    if (back ? !mayTurnBack(map) : !mayTurn(map)) return;
    turn(*wanted_, back ? GridEventKind::Reversed : GridEventKind::Turned);
    wanted_.reset();
}

bool GridMover::mayTurn(const TileMap& map) const {
    const CorneringWindow& window = def_.cornering.of(heading_);
    const bool near = along() >= -window.before * def_.pixelsPerTile && along() <= window.after * def_.pixelsPerTile;
    return near && open(map, *wanted_);
}

/// Past the centre, that is what lies behind; else it is the cell from which it came.
bool GridMover::mayTurnBack(const TileMap& map) const {
    const Direction back = opposite(heading_);
    if (def_.reverses) return along() > 0 || open(map, back);
    if (along() != 0 || !open(map, back)) return false;
    return std::none_of(allDirections.begin(), allDirections.end(),
                        [&](Direction exit) { return exit != back && open(map, exit); });
}

void GridMover::turn(Direction direction, GridEventKind kind) {
    heading_ = direction;
    tell(kind);
}

/// As far as the next place at which there is something to decide; returns the way it took.
double GridMover::goOn(const TileMap& map, double way) {
    const double past = along();
    const bool atCentre = past == 0 && aside() == 0;
    if (past >= 0 && !open(map, heading_)) return held(way);
    if (halted_ && atCentre) return held(way);
    stopped_ = false;
    const double target = reach(map);
    const double step = std::min(way, target - past);
    setAlong(step == target - past ? target : past + step);
    closeIn(step);
    if (past < 0 && along() == 0 && aside() == 0) tell(GridEventKind::ReachedCentre);
    return step;
}

/// A wall is ahead, or it is to halt at this centre.
double GridMover::held(double way) {
    if (along() > 0) {  // the wall was put up when it was past the centre: it goes back there
        turn(opposite(heading_), GridEventKind::Reversed);
        return 0;
    }
    if (aside() != 0) {
        const double step = std::min(way, std::fabs(aside()));
        closeIn(step);
        if (aside() == 0) tell(GridEventKind::ReachedCentre);
        return step;
    }
    if (!stopped_) tell(GridEventKind::Stopped);
    stopped_ = true;
    return way;
}

/// How far along the heading the next place lies: the window of a wanted turn, the centre, or the edge of the cell.
double GridMover::reach(const TileMap& map) const {
    const double past = along();
    if (past >= 0) return half();
    const double opening = -def_.cornering.of(heading_).before * def_.pixelsPerTile;
    const bool turning = wanted_ && isHorizontal(*wanted_) != isHorizontal(heading_) && past < opening;
    return turning && open(map, *wanted_) ? opening : 0;
}

/// The right and upper edges belong to the cell, the left and lower ones to its neighbours.
void GridMover::crossIfDue(const TileMap& map, bool wayLeft) {
    if (along() == half() && (wayLeft || !isForward(heading_))) cross(map);
}

void GridMover::cross(const TileMap& map) {
    const Cell next = neighbourOf(cell_, heading_);
    const Cell inside = map.wrapped(next);
    cell_ = inside;
    setAlong(-half());
    if (!(inside == next)) tell(GridEventKind::Wrapped);
    tell(GridEventKind::Entered);
    entered_ = true;
}

void GridMover::turnBackIfEntered(const TileMap& map) {
    const bool entered = std::exchange(entered_, false);
    if (!entered || !reversing_ || !open(map, opposite(heading_))) return;
    reversing_ = false;
    turn(opposite(heading_), GridEventKind::Reversed);
}

double GridMover::along() const {
    const double offset = isHorizontal(heading_) ? x_ : y_;
    return isForward(heading_) ? offset : -offset;
}

void GridMover::setAlong(double distance) {
    axis(isHorizontal(heading_)) = isForward(heading_) ? distance : 0 - distance;  // no -0
}

void GridMover::closeIn(double way) {
    double& off = axis(!isHorizontal(heading_));
    off = off > 0 ? std::max(0.0, off - way) : std::min(0.0, off + way);
}

}  // namespace plumb
