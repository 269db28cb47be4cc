// SPDX-License-Identifier: MIT
// How does a player's input move a character through a platform game?
#pragma once
#include <limits>

#include <plumb/movers/platform_profile.h>

namespace plumb {

namespace detail {
struct TickMotion;
}

/// What is held, in this tick.
struct PlatformInput {
    double move = 0;  ///< to the left or right, -1 to 1 [-]
    bool run = false;
    bool jump = false;
    bool down = false;
    bool swim = false;  ///< it is in water, if its profile can swim
};

/// Moves a kinematic body of a world; keeps no hold on that world, so a copy goes on in a copy of it.
class PlatformMover {
public:
    /// Throws std::invalid_argument on a profile out of range.
    explicit PlatformMover(BodyId body, const PlatformProfile& profile = modernProfile());

    /// One tick, before World::step(dt): finds fresh presses, jumps, and moves by moveAndSlide(), whose answer it
    /// gives; later is as SlideMotion has it. Throws std::invalid_argument as that does, and unless move is -1 to 1; dt
    /// is > 0 [s].
    const Slide& step(World& world, const PlatformInput& input, double dt, std::span<const BodyId> later = {});

    BodyId body() const { return body_; }
    const PlatformProfile& profile() const { return profile_; }
    void setProfile(const PlatformProfile& profile);  ///< throws as the constructor
    const Slide& slide() const { return slide_; }     ///< what came of the last tick
    bool hasJumped() const { return hasJumped_; }     ///< did it take off in the last tick?
    /// For a blow, as in Slide; upward it lifts off the floor, and falls as a jump let go [m/s].
    void setVelocity(const Vec2& velocity);
    /// For a spring: upward it rises by v^2 / 2g, whether jump is held, let go or pressed; no jump takes its place.
    /// v its upward speed [m/s], g riseGravity of the first JumpBand [m/s^2]; ticks that are not TickOrder::Exact are
    /// off by half of one's way.
    /// Test: "a launch rises by its closed form whether jump is held, let go or pressed on the way"
    void launch(const Vec2& velocity);

private:
    detail::TickMotion levelPart(const PlatformInput& input, double speed, double dt);
    detail::TickMotion verticalPart(const PlatformInput& input, double speed, double dt);
    const JumpBand& band(const PlatformInput& input) const;
    bool takesOff(const PlatformInput& input, bool fresh, double dt) const;
    bool dropsThrough(const World& world, const PlatformInput& input, bool fresh) const;

    BodyId body_;
    PlatformProfile profile_;
    Slide slide_;
    std::size_t band_ = 0;   ///< of profile_.vertical.jumps
    bool rising_ = false;    ///< with jump held all the time
    bool launched_ = false;  ///< and rising since
    bool jumpHeld_ = false;  ///< in the last tick
    bool hasJumped_ = false;
    bool thrown_ = false;                                          ///< by setVelocity or launch, since the last tick
    bool mayStillJump_ = false;                                    ///< it left the floor without a jump
    double risen_ = 0;                                             ///< in this jump [m]
    double sinceFloor_ = 0;                                        ///< [s]
    double sincePress_ = std::numeric_limits<double>::infinity();  ///< of a jump not made yet [s]
    double sinceRun_ = std::numeric_limits<double>::infinity();    ///< [s]
};

}  // namespace plumb
