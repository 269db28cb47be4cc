// SPDX-License-Identifier: MIT
// How does a player's input move a character in a platform game?
#pragma once
#include <limits>

#include <plumb/movers/platform_profile.h>

namespace plumb {

namespace detail {
struct TickMotion;
}

/// The input of one tick.
struct PlatformInput {
    double move = 0;  ///< left or right, -1 to 1 [-]
    bool run = false;
    bool jump = false;
    bool down = false;
    bool swim = false;  ///< it is in water; used if its profile can swim
};

/// Moves a kinematic body of a world; it keeps no reference to that world, so a copy works in a copy of the world.
class PlatformMover {
public:
    /// Throws std::invalid_argument on a profile out of range.
    explicit PlatformMover(BodyId body, const PlatformProfile& profile = modernProfile());

    /// One tick, before World::step(dt): detects new key presses, jumps, and calls moveAndSlide(), whose result it
    /// returns; later is as in SlideMotion. Throws std::invalid_argument as that does, and unless move is -1 to 1; dt
    /// is > 0 [s].
    const Slide& step(World& world, const PlatformInput& input, double dt, std::span<const BodyId> later = {});

    BodyId body() const { return body_; }
    const PlatformProfile& profile() const { return profile_; }
    void setProfile(const PlatformProfile& profile);  ///< throws as the constructor
    const Slide& slide() const { return slide_; }     ///< the result of the last tick
    bool hasJumped() const { return hasJumped_; }     ///< did it jump in the last tick?
    /// For a blow, relative as in Slide; an upward velocity leaves the floor, and then falls as after releasing jump
    /// [m/s].
    void setVelocity(const Vec2& velocity);
    /// For a spring: with an upward velocity it rises by v^2 / 2g, whether jump is held, released or pressed; a jump
    /// cannot interrupt it. v its upward speed [m/s], g riseGravity of the first JumpBand [m/s^2]; with another order
    /// than TickOrder::Exact the error is half of a tick's motion.
    /// Test: "a launch rises by its closed form whether jump is held, let go or pressed on the way"
    void launch(const Vec2& velocity);

private:
    detail::TickMotion horizontalPart(const PlatformInput& input, double speed, double dt);
    detail::TickMotion verticalPart(const PlatformInput& input, double speed, double dt);
    const JumpBand& band(const PlatformInput& input) const;
    bool takesOff(const PlatformInput& input, bool fresh, double dt) const;
    bool dropsThrough(const World& world, const PlatformInput& input, bool fresh) const;

    BodyId body_;
    PlatformProfile profile_;
    Slide slide_;
    std::size_t band_ = 0;   ///< of profile_.vertical.jumps
    bool rising_ = false;    ///< with jump held all the time
    bool launched_ = false;  ///< and still rising
    bool jumpHeld_ = false;  ///< in the last tick
    bool hasJumped_ = false;
    bool thrown_ = false;                                          ///< by setVelocity or launch, since the last tick
    bool mayStillJump_ = false;                                    ///< it left the floor without a jump
    double risen_ = 0;                                             ///< in this jump [m]
    double holdLeft_ = 0;                                          ///< of the hold phase of this jump [s]
    double sinceFloor_ = 0;                                        ///< [s]
    double sincePress_ = std::numeric_limits<double>::infinity();  ///< for a jump that was not made yet [s]
    double sinceRun_ = std::numeric_limits<double>::infinity();    ///< [s]
};

}  // namespace plumb
