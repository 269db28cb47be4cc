// SPDX-License-Identifier: MIT
// What does one hunter do, frame by frame?
#pragma once
#include <optional>

#include <games/frame/hash.h>
#include <games/maze/house_walk.h>
#include <plumb/math/random.h>
#include <plumb/movers/grid_mover.h>

namespace plumb::games::maze {

enum class Where : std::uint8_t {
    Home,      ///< waits in the house
    Leaving,   ///< on the way to the doorstep
    Lanes,     ///< hunts, rests or is frightened
    Eyes,      ///< was caught: runs to the doorstep
    Entering,  ///< on the way home
};

/// What a hunter knows when it chooses its way.
struct Sight {
    Cell player;
    Direction heading;  ///< the player's
    Cell chaser;
    bool rests = false;  ///< true: it goes to its corner
};

class Hunter {
public:
    /// At the start of a life the chaser is on the doorstep, and the others are at home.
    explicit Hunter(Who who);

    /// Runs one frame. In the lanes it moves at this speed: to its target or, if frightened, in random directions.
    void step(const Sight& sight, SpeedPattern speed, Random& random);
    Cell targetFor(const Sight& sight) const { return targetFrom(cell(), sight); }

    void letOut() { where_ = Where::Leaving; }
    void turnBack();  ///< in lanes: when it enters the next cell; in the house: it will leave to the right
    void takeFright() { frightened_ = true; }
    void takeHeart() { frightened_ = false; }
    void beCaught();

    Who who() const { return who_; }
    Where where() const { return where_; }
    bool frightened() const { return frightened_; }
    bool canMeet() const { return where_ == Where::Lanes; }  ///< can catch the player, or be caught
    bool isInLanes() const { return where_ == Where::Lanes || where_ == Where::Eyes; }
    Cell cell() const { return mover_.cell(); }  ///< valid only in lanes
    Direction heading() const;
    /// The exit that it has chosen for the next cell.
    Direction plan() const { return plan_; }
    Vec2 position() const;  ///< [tiles]
    void addTo(Hash& hash) const;

private:
    Cell targetFrom(Cell from, const Sight& sight) const;
    void run(const Sight& sight, SpeedPattern speed, Random& random);
    /// Sets plan_ while the hunter is in the cell from.
    void decide(Cell from, const Sight& sight, Random& random);
    void beginLanes();

    Who who_;
    Where where_;
    bool frightened_ = false;
    bool leavesRight_ = false;
    HouseWalk walk_;
    GridMover mover_;
    Direction exit_ = Direction::Left;  ///< of its current cell
    Direction plan_ = Direction::Left;  ///< of the next cell
};

}  // namespace plumb::games::maze
