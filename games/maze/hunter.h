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
    Lanes,     ///< hunting
    Eyes,      ///< caught: runs to the doorstep
    Entering,  ///< on the way home
};

/// What a hunter knows, and is told.
struct Sight {
    Cell player;
    Direction heading;  ///< the player's
    Cell chaser;
    bool rests = false;  ///< scatters
};

class Hunter {
public:
    /// Where it begins a life: the chaser on the doorstep, the others at home.
    explicit Hunter(Who who);

    /// One frame. In lanes it makes for its target at that speed, or, when frightened, anywhere.
    void step(const Sight& sight, SpeedPattern speed, Random& random);
    Cell targetFor(const Sight& sight) const { return targetFrom(cell(), sight); }

    void letOut() { where_ = Where::Leaving; }
    void turnBack();  ///< when it enters the next cell; who is in the house will leave it the other way
    void takeFright() { frightened_ = true; }
    void takeHeart() { frightened_ = false; }
    void beCaught();

    Who who() const { return who_; }
    Where where() const { return where_; }
    bool frightened() const { return frightened_; }
    bool canMeet() const { return where_ == Where::Lanes; }  ///< the player
    bool isInLanes() const { return where_ == Where::Lanes || where_ == Where::Eyes; }
    Cell cell() const { return mover_.cell(); }  ///< in lanes
    Direction heading() const;
    /// The exit that it has chosen of the cell that comes after this one.
    Direction plan() const { return plan_; }
    Vec2 position() const;  ///< [tiles]
    void addTo(Hash& hash) const;

private:
    Cell targetFrom(Cell from, const Sight& sight) const;
    void run(const Sight& sight, SpeedPattern speed, Random& random);
    /// The plan for the cell beyond the exit of the one that it is in, from.
    void decide(Cell from, const Sight& sight, Random& random);
    void beginLanes();

    Who who_;
    Where where_;
    bool frightened_ = false;
    bool leavesRight_ = false;
    HouseWalk walk_;
    GridMover mover_;
    Direction exit_ = Direction::Left;  ///< of the cell it is in
    Direction plan_ = Direction::Left;  ///< of the next one
};

}  // namespace plumb::games::maze
