// SPDX-License-Identifier: MIT
// How does a character of a platform game run, jump and fall?
#pragma once
#include <optional>
#include <string>
#include <vector>

#include <plumb/movers/move_and_slide.h>

namespace plumb {

/// How one jumps who takes off at a speed of at least fromSpeed; gravities are downward.
struct JumpBand {
    double fromSpeed = 0;        ///< along the floor, >= 0 [m/s]
    double takeOffSpeed = 10;    ///< up, >= 0 [m/s]
    double riseGravity = 25;     ///< while it rises and jump is held, >= 0 [m/s^2]
    double releaseGravity = 50;  ///< while it rises and jump was let go, >= 0 [m/s^2]
    double fallGravity = 50;     ///< while it falls, >= 0 [m/s^2]
};

/// What a tick does to place and speed.
enum class TickOrder {
    Exact,          ///< the very parabola: frame-rate independent
    PositionFirst,  ///< x += v, then v += a, in whole ticks
    VelocityFirst,  ///< v += a, then x += v
};

/// Of who is faster than the speed wanted, and pushes on that way.
enum class OverSpeed {
    Slow,  ///< loses speed as without input
    Cut,   ///< has that speed, at once
};

struct LevelMotion {
    double walkSpeed = 4, runSpeed = 7;                  ///< >= 0 [m/s]
    double walkAcceleration = 40, runAcceleration = 40;  ///< >= 0 [m/s^2]
    std::optional<double> friction = 60;     ///< without input, on a floor; empty: as it would accelerate [m/s^2]
    std::optional<double> airFriction = 20;  ///< the same in the air [m/s^2]
    double airShare = 0.65;                  ///< of the acceleration, in the air, >= 0 [-]
    double turnFactor = 1.5;                 ///< of the acceleration while it moves the other way, >= 0 [-]
    double turnStopSpeed = 0;                ///< slower who turns stops at once, on a floor, >= 0 [m/s]
    std::optional<double> fastSpeed = std::nullopt;    ///< at least as fast, and not running, ... [m/s]
    double fastAcceleration = 0;                       ///< ... it has this acceleration, >= 0 [m/s^2]
    std::optional<double> airRunSpeed = std::nullopt;  ///< in the air, only who is as fast runs; empty: as on a floor
    double runGrace = 0;                               ///< it still runs for this after run was let go, >= 0 [s]
    bool runNeedsMotion = false;                       ///< run counts only for who pushes on the way that it moves
    OverSpeed overSpeed = OverSpeed::Slow;
    TickOrder order = TickOrder::Exact;
    double moveGrain = 0;  ///< what it moves in a tick is cut to whole multiples of this, >= 0; 0: it is not [m]
};

struct VerticalMotion {
    std::vector<JumpBand> jumps = {JumpBand{}};  ///< by fromSpeed, rising from 0
    double leastRise = 0;       ///< a jump let go before it rose so far goes on rising till then, >= 0 [m]
    double hangSpeed = 0;       ///< slower than this up or down, while jump is held, ... >= 0 [m/s]
    double hangShare = 1;       ///< ... gravity is this part of itself, > 0 [-]
    double terminalSpeed = 20;  ///< downward, > 0 [m/s]
    /// Not 0: the speed is cut to the terminal speed only when it has reached it and is by half of this or more above a
    /// whole multiple of it, so it swings about [m/s].
    double terminalUnit = 0;
    double coyoteTime = 0;  ///< it may still jump after it ran off, >= 0 [s]
    double jumpBuffer = 0;  ///< a jump asked for in the air is made on landing, >= 0 [s]
    TickOrder order = TickOrder::Exact;
};

/// In water every fresh press of jump is a stroke, on a floor or not.
struct SwimMotion {
    double speed = 3;  ///< at most, to the sides, >= 0 [m/s]
    JumpBand stroke = {.takeOffSpeed = 4, .riseGravity = 6, .releaseGravity = 8, .fallGravity = 5};
};

struct PlatformProfile {
    LevelMotion level;
    VerticalMotion vertical;
    std::optional<SwimMotion> swim = std::nullopt;  ///< without, water is air
    SlideSettings slide;
    bool dropThrough = true;  ///< down and jump on a one-way floor drops through it
    /// What a tick moves, and by how much that changes, are rounded to whole multiples of this, >= 0; 0: they are not.
    /// A power of two makes all of it exact [m].
    double grain = 0;
};

/// What a jump is to be like.
struct JumpFeel {
    double height = 2.5;         ///< with jump held, > 0 [m]
    double timeToApex = 0.4;     ///< > 0 [s]
    double fallFactor = 1.6;     ///< of gravity while falling, > 0 [-]
    double releaseFactor = 3;    ///< of gravity while rising with jump let go, > 0 [-]
    double hangSpeedPart = 0.1;  ///< of the take-off speed, below which it hangs, 0 to 1 [-]
    double hangShare = 0.5;      ///< of gravity while it hangs, > 0 [-]
};

/// Speed and gravity from height and time to the apex, with the tolerances that players expect.
///   v = 2 h / T (1 + a k) / (1 + a^2 k),  g = v / T (1 + a k),  k = 1 / s - 1
/// h height [m], T time to apex [s], a hangSpeedPart [-], s hangShare [-], v take-off speed [m/s], g gravity [m/s^2]
/// Source: v = g t and h = g t^2 / 2 over the two stretches, with gravity g and s g.
/// Test: "a jump is 2.5 m high at 30, 60, 120 and 240 Hz"
PlatformProfile modernProfile(const JumpFeel& feel = {});

/// The platform game of 1985 whose tables public disassemblies give: NTSC, 60.0988 ticks a second, 16
/// pixels a metre, all speeds whole multiples of 1/4096 pixel a tick. Step it by tickOf1985.
/// It swims by that game's strokes. Tests: [arcade], "walking takes 41 ticks to full speed, running 45"
PlatformProfile profile1985();
inline constexpr double tickOf1985 = 1 / 60.0988;  ///< [s]
inline constexpr double entryMove1985 = 0.5;       ///< PlatformInput::move of who is led into a scene: 0Ch of 18h [-]

/// Throws std::invalid_argument naming the field, the value and what was wanted; field is the name of the whole.
void validate(const PlatformProfile& profile, const std::string& field);

}  // namespace plumb
