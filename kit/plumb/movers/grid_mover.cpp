// SPDX-License-Identifier: MIT
#include <plumb/movers/grid_mover.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <plumb/math/check.h>

namespace plumb {

namespace {

constexpr int maxPixels = 1 << 20;
constexpr double maxTilesAtOnce = 1 << 20;
constexpr int maxFrames = 1 << 30;

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

/// The part of a tick's motion that remains after a pause; reduces the remaining pause.
double withoutPause(double distance, double dt, double& remainingPause) {
    const double paused = std::min(remainingPause, dt);
    remainingPause -= paused;
    return paused == dt ? 0 : distance * ((dt - paused) / dt);
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
    if (def.pixelsPerTile < 1 || def.pixelsPerTile > maxPixels)
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

void GridMover::pauseFrames(int frames) {
    if (frames < 0 || frames > maxFrames - pauseFrames_)
        refuse("GridMover.pauseFrames: frames", std::to_string(frames) + " is not within 0 to 2^30, all together");
    pauseFrames_ += frames;
}

void GridMover::pause(double time) {
    requireNotNegative(time, "GridMover.pause: time");
    requireFinite(pause_ + time, "GridMover.pause: time");
    pause_ += time;
}

std::span<const GridEvent> GridMover::move(const TileMap& map, double speed, double dt) {
    requireNotNegative(speed, "GridMover.move: speed");
    requireNotNegative(dt, "GridMover.move: dt");
    requireWithin(speed * dt, 0, maxTilesAtOnce, "GridMover.move: speed dt");
    begin(map);
    moveBy(map, withoutPause(speed * dt * def_.pixelsPerTile, dt, pause_));
    return events_;
}

std::span<const GridEvent> GridMover::moveFrame(const TileMap& map, SpeedPattern speed) {
    begin(map);
    if (pauseFrames_ > 0) {
        --pauseFrames_;
        return events_;
    }
    for (int pixels = speed.pixels(frame_++); pixels > 0; --pixels) movePixel(map);
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

void GridMover::moveBy(const TileMap& map, double distance) {
    while (distance > 0) {
        reverseIfEntered(map);
        takeWantedTurn(map);
        distance -= advance(map, distance);
        crossIfAtEdge(map, distance > 0);
    }
}

/// A reversal on entry happens when the mover is one pixel inside the cell.
void GridMover::movePixel(const TileMap& map) {
    reverseIfEntered(map);
    for (double distance = 1; distance > 0;) {
        takeWantedTurn(map);
        distance -= advance(map, distance);
        crossIfAtEdge(map, distance > 0);
    }
}

/// Makes the wanted turn, if it is possible here.
void GridMover::takeWantedTurn(const TileMap& map) {
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

/// Past the centre, the way back leads through this cell; before it, through the cell from which it came.
bool GridMover::mayTurnBack(const TileMap& map) const {
    const Direction back = opposite(heading_);
    if (def_.reverses) return along() > 0 || open(map, back);
    if (along() != 0 || !open(map, back)) return false;
    return std::none_of(allDirections.begin(), allDirections.end(),
                        [&](Direction exit) { return exit != back && open(map, exit); });
}

void GridMover::turn(Direction direction, GridEventKind kind) {
    heading_ = direction;
    addEvent(kind);
}

/// Moves to the next point at which a decision is due; returns the distance.
double GridMover::advance(const TileMap& map, double distance) {
    const double past = along();
    const bool atCentre = past == 0 && aside() == 0;
    if (past >= 0 && !open(map, heading_)) return stopAhead(distance);
    if (halted_ && atCentre) return stopAhead(distance);
    stopped_ = false;
    const double target = nextDecision(map);
    const double step = std::min(distance, target - past);
    setAlong(step == target - past ? target : past + step);
    approachLane(step);
    if (past < 0 && along() == 0 && aside() == 0) addEvent(GridEventKind::ReachedCentre);
    return step;
}

/// A wall is ahead, or it has to halt at this centre.
double GridMover::stopAhead(double distance) {
    if (along() > 0) {  // the wall was closed when it was past the centre: it goes back
        turn(opposite(heading_), GridEventKind::Reversed);
        return 0;
    }
    if (aside() != 0) {
        const double step = std::min(distance, std::fabs(aside()));
        approachLane(step);
        if (aside() == 0) addEvent(GridEventKind::ReachedCentre);
        return step;
    }
    if (!stopped_) addEvent(GridEventKind::Stopped);
    stopped_ = true;
    return distance;
}

/// How far along the heading the next decision point is: the window of a wanted turn, the centre, or the edge of the
/// cell.
double GridMover::nextDecision(const TileMap& map) const {
    const double past = along();
    if (past >= 0) return half();
    const double opening = -def_.cornering.of(heading_).before * def_.pixelsPerTile;
    const bool turning = wanted_ && isHorizontal(*wanted_) != isHorizontal(heading_) && past < opening;
    return turning && open(map, *wanted_) ? opening : 0;
}

/// The right and upper edges belong to the cell, the left and lower edges to its neighbours.
void GridMover::crossIfAtEdge(const TileMap& map, bool distanceLeft) {
    if (along() == half() && (distanceLeft || !isForward(heading_))) cross(map);
}

void GridMover::cross(const TileMap& map) {
    const Cell next = neighbourOf(cell_, heading_);
    const Cell inside = map.wrapped(next);
    cell_ = inside;
    setAlong(-half());
    if (!(inside == next)) addEvent(GridEventKind::Wrapped);
    addEvent(GridEventKind::Entered);
    entered_ = true;
}

void GridMover::reverseIfEntered(const TileMap& map) {
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

void GridMover::approachLane(double distance) {
    double& off = axis(!isHorizontal(heading_));
    off = off > 0 ? std::max(0.0, off - distance) : std::min(0.0, off + distance);
}

}  // namespace plumb
