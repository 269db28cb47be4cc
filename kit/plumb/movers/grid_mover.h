// SPDX-License-Identifier: MIT
// How does an object move through a maze, tile by tile, at any speed?
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <plumb/math/overload.h>
#include <plumb/movers/grid_pass.h>
#include <plumb/movers/grid_pattern.h>

namespace plumb {

/// How far from a cell's centre a turn may start, 0 to 1/2 [tiles].
struct CorneringWindow {
    double before = 0, after = 0;
};

/// For each direction of approach. All 0: turns at centres only.
struct Cornering {
    CorneringWindow up = {}, left = {}, down = {}, right = {};

    const CorneringWindow& of(Direction heading) const;
};

struct GridMoverDef {
    Cell cell = {};
    Vec2 offset{0, 0};  ///< from its centre, at the start: along heading only, above -1/2, to 1/2 [tiles]
    Direction heading = Direction::Right;
    GridPass pass = {};
    Cornering cornering = {};
    bool reverses = true;   ///< may reverse anywhere, at once; otherwise only in a dead end, or by reverseOnEntry
    bool halted = false;    ///< waits for the first call of want
    int pixelsPerTile = 8;  ///< for moveFrame, 1 to 2^20
};

enum class GridEventKind : std::uint8_t {
    Entered,        ///< a cell, heading in direction
    ReachedCentre,  ///< of the cell; not reported when the corner is cut
    Turned,         ///< into direction
    Reversed,       ///< into direction
    Stopped,        ///< at the centre, before a wall that lies in direction, or halted: with distance left to go
    Wrapped,        ///< over the map's edge, in direction: its position jumps. Followed by Entered
};

struct GridEvent {
    GridEventKind kind = GridEventKind::Entered;
    Cell cell = {};
    Direction direction = Direction::Right;
    friend bool operator==(const GridEvent&, const GridEvent&) = default;
};

/// Moves on the lanes of a tile map, the lines through the centres of its cells. Its position is a cell and an offset
/// from its centre: centres are reached exactly, the rest of a tick's motion continues beyond them, and rounding does
/// not accumulate from cell to cell. A wanted turn is made as soon as the cell, the windows and the walls allow it. A
/// turn before or after the centre cuts the corner: it moves on both axes equally, sqrt(2) times as fast, until it is
/// on the new lane, and never leaves its cell meanwhile. Cells are half-open, (-1/2, 1/2] tiles on both axes: the
/// arcade's 3 pixels on one side of the centre pixel and 4 on the other.
/// Source: The Pac-Man Dossier, chapter 3, "Cornering".
/// Tests: "one hour of random input ...", "every early turn gains and every late turn loses a frame a pixel ..."
class GridMover {
public:
    /// Throws std::invalid_argument naming the field.
    explicit GridMover(const GridMoverDef& def = {});
    explicit GridMover(detail::EmptyBraces) : GridMover() {}

    /// Turn in this direction as soon as possible; the last call counts, until the turn is made. Ends a halt.
    void want(Direction direction);
    void wantNothing() { wanted_.reset(); }
    void halt() { halted_ = true; }  ///< at the next centre, until the next call of want
    /// Reverses as soon as it enters another cell, once; also a mover that may not reverse otherwise.
    void reverseOnEntry();
    /// Pauses for this number of calls of moveFrame, as does its pattern; added to a pause in progress. >= 0.
    void pauseFrames(int frames);
    void pause(double time);  ///< the same for move: a time that does not count [s]
    void setPass(const GridPass& pass) { def_.pass = pass; }
    void setCornering(const Cornering& cornering);  ///< throws as the constructor

    /// Moves by speed dt: >= 0 and finite, together at most 2^20 tiles [tiles/s, s]. Returns the events in order; valid
    /// until the next move. Throws std::invalid_argument on these, and when its cell is not on the map.
    std::span<const GridEvent> move(const TileMap& map, double speed, double dt);
    /// One frame of the pattern, pixel by pixel.
    std::span<const GridEvent> moveFrame(const TileMap& map, SpeedPattern speed);

    Cell cell() const { return cell_; }  ///< that contains its position
    Direction heading() const { return heading_; }
    std::optional<Direction> wanted() const { return wanted_; }
    bool stopped() const { return stopped_; }  ///< at a wall, or halted, after the last move
    /// From the centre of its cell [tiles]: on one axis at most, except while it cuts a corner.
    Vec2 offset() const { return Vec2(x_, y_) / def_.pixelsPerTile; }
    /// In the map's frame [m]. For a kinematic body call body.moveTo(position, angle, dt), but setPose in a tick in
    /// which it wrapped.
    Vec2 position(const TileMap& map) const { return map.centerOf(cell_) + offset() * map.size(); }
    const GridMoverDef& def() const { return def_; }

private:
    void begin(const TileMap& map);
    void moveBy(const TileMap& map, double distance);
    void movePixel(const TileMap& map);
    void takeWantedTurn(const TileMap& map);
    bool mayTurn(const TileMap& map) const;
    bool mayTurnBack(const TileMap& map) const;
    void turn(Direction direction, GridEventKind kind);
    double advance(const TileMap& map, double distance);
    double stopAhead(double distance);
    double nextDecision(const TileMap& map) const;
    void crossIfAtEdge(const TileMap& map, bool distanceLeft);
    void cross(const TileMap& map);
    void reverseIfEntered(const TileMap& map);
    bool open(const TileMap& map, Direction direction) const { return isOpen(map, cell_, direction, def_.pass); }
    void addEvent(GridEventKind kind) { events_.push_back({kind, cell_, heading_}); }

    double& axis(bool horizontal) { return horizontal ? x_ : y_; }
    double along() const;            ///< past the centre, in its heading [pixels]
    void setAlong(double distance);  ///< [pixels]
    double aside() const { return isHorizontal(heading_) ? y_ : x_; }
    void approachLane(double distance);  ///< towards its lane
    double half() const { return 0.5 * def_.pixelsPerTile; }

    GridMoverDef def_;
    Cell cell_;
    Direction heading_;
    std::optional<Direction> wanted_;
    double x_ = 0, y_ = 0;  ///< from the centre of the cell [pixels]
    double pause_ = 0;      ///< [s]
    int pauseFrames_ = 0;
    std::uint32_t frame_ = 0;
    bool halted_ = false, stopped_ = false, reversing_ = false, entered_ = false;
    std::vector<GridEvent> events_;
};

}  // namespace plumb
