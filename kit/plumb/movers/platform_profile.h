// SPDX-License-Identifier: MIT
// How does a character of a platform game run, jump and fall?
#pragma once
#include <optional>
#include <string>
#include <vector>

#include <plumb/movers/move_and_slide.h>

namespace plumb {

/// Parameters of a jump at a horizontal speed of at least fromSpeed; gravities are downward.
struct JumpBand {
    double fromSpeed = 0;        ///< along the floor, >= 0 [m/s]
    double takeOffSpeed = 10;    ///< up, >= 0 [m/s]
    double riseGravity = 25;     ///< while rising with jump held, >= 0 [m/s^2]
    double releaseGravity = 50;  ///< while rising with jump released, >= 0 [m/s^2]
    double fallGravity = 50;     ///< while falling, >= 0 [m/s^2]
    /// The hold phase: for this time from the take-off, while jump is held, there is no gravity, but ... >= 0 [s]
    double holdTime = 0;
    double holdAcceleration = 0;  ///< ... this, upward; 0 keeps the take-off speed [m/s^2]
};

/// The height of a jump whose jump key is held for a time t [s], or longer than any jump with infinity.
///   h = v s + a s^2 / 2 + w^2 / (2 g),  s = min(t, T),  w = v + a s, with jump held up to the apex
/// and with jump released at t <= T
///   h = v s + a s^2 / 2 + w^2 / (2 g')
/// h height [m], v takeOffSpeed [m/s], a holdAcceleration [m/s^2], T holdTime [s], w speed at the end of the hold phase
/// [m/s], g riseGravity, g' releaseGravity [m/s^2]; released later, between the two, with g first and then g'. A
/// negative a may end the rise within the phase, at h = -v^2 / (2 a). Infinite without gravity.
/// Holds: TickOrder::Exact, no hangSpeed, no leastRise. Throws std::invalid_argument on a band out of range, and unless
/// held >= 0. Test: "a jump with a hold phase rises by its closed form, whenever jump is let go"
double jumpHeight(const JumpBand& band, double held);

/// How a tick changes position and speed.
enum class TickOrder {
    Exact,          ///< the exact parabola: independent of frame rate
    PositionFirst,  ///< x += v, then v += a, in whole ticks
    VelocityFirst,  ///< v += a, then x += v
};

/// What happens at a speed above the wanted one, with input in the same direction.
enum class OverSpeed {
    Slow,  ///< decelerates as without input
    Cut,   ///< has the wanted speed, at once
};

struct HorizontalMotion {
    double walkSpeed = 4, runSpeed = 7;                  ///< >= 0 [m/s]
    double walkAcceleration = 40, runAcceleration = 40;  ///< >= 0 [m/s^2]
    std::optional<double> friction = 60;                 ///< without input, on a floor; empty: as acceleration [m/s^2]
    std::optional<double> airFriction = 20;              ///< the same in the air [m/s^2]
    double airShare = 0.65;                              ///< of the acceleration, in the air, >= 0 [-]
    double turnFactor = 1.5;   ///< of the acceleration while it moves in the opposite direction, >= 0 [-]
    double turnStopSpeed = 0;  ///< turning below this speed stops at once, on a floor, >= 0 [m/s]
    std::optional<double> fastSpeed = std::nullopt;    ///< at this speed or more, and not running, ... [m/s]
    double fastAcceleration = 0;                       ///< ... it has this acceleration, >= 0 [m/s^2]
    std::optional<double> airRunSpeed = std::nullopt;  ///< in the air, runs from this speed on; empty: as on a floor
    double runGrace = 0;                               ///< it still runs for this time after run was released, >= 0 [s]
    bool runNeedsMotion = false;                       ///< run counts only with input in the direction of motion
    OverSpeed overSpeed = OverSpeed::Slow;
    TickOrder order = TickOrder::Exact;
    double moveGrain = 0;  ///< the displacement per tick is truncated to multiples of this, >= 0; 0: it is not [m]
};

struct VerticalMotion {
    std::vector<JumpBand> jumps = {JumpBand{}};  ///< by fromSpeed, increasing from 0
    double leastRise = 0;                        ///< a jump released earlier still rises by this much, >= 0 [m]
    double hangSpeed = 0;                        ///< below this vertical speed, while jump is held, ... >= 0 [m/s]
    double hangShare = 1;                        ///< ... gravity is multiplied by this, > 0 [-]
    double terminalSpeed = 20;                   ///< downward, > 0 [m/s]
    /// If not 0: the speed is limited to the terminal speed only when it has reached it and exceeds a multiple of this
    /// by half of this or more, so it oscillates [m/s].
    double terminalUnit = 0;
    double coyoteTime = 0;  ///< it may still jump this long after leaving a floor, >= 0 [s]
    double jumpBuffer = 0;  ///< a jump requested in the air is made on landing within this time, >= 0 [s]
    TickOrder order = TickOrder::Exact;
};

/// In water every new press of jump is a stroke, on a floor or not.
struct SwimMotion {
    double speed = 3;  ///< horizontal, at most, >= 0 [m/s]
    JumpBand stroke = {.takeOffSpeed = 4, .riseGravity = 6, .releaseGravity = 8, .fallGravity = 5};
};

struct PlatformProfile {
    HorizontalMotion horizontal;
    VerticalMotion vertical;
    std::optional<SwimMotion> swim = std::nullopt;  ///< if empty, water has no effect
    SlideSettings slide;
    bool dropThrough = true;  ///< down and jump on a one-way floor drops through it
    /// The displacement per tick and its change are rounded to multiples of this, >= 0; 0: they are not. A power of two
    /// makes all of it exact [m].
    double grain = 0;
};

/// Parameters of a jump as a designer describes it.
struct JumpFeel {
    double height = 2.5;         ///< with jump held, > 0 [m]
    double timeToApex = 0.4;     ///< > 0 [s]
    double fallFactor = 1.6;     ///< of gravity while falling, > 0 [-]
    double releaseFactor = 3;    ///< of gravity while rising with jump released, > 0 [-]
    double hangSpeedPart = 0.1;  ///< of the take-off speed, below which gravity is reduced, 0 to 1 [-]
    double hangShare = 0.5;      ///< of gravity near the apex, > 0 [-]
    double holdTime = 0;         ///< at the take-off speed, while jump is held, from 0 to below timeToApex [s]
};

/// Speed and gravity from height and time to the apex, with the usual tolerances for players (coyote time, jump
/// buffer).
///   v = 2 h / (T + 2 H b) b,  b = (1 + a k) / (1 + a^2 k),  g = v / T (1 + a k),  k = 1 / s - 1
/// h height [m], H holdTime [s], T time to apex less H [s], a hangSpeedPart [-], s hangShare [-], v take-off speed
/// [m/s], g gravity [m/s^2]
/// Source: h = v H + the sum of g t^2 / 2 over the two parts, with gravity g and s g, in which v is lost.
/// Test: "a jump is 2.5 m high at 30, 60, 120 and 240 Hz"
PlatformProfile modernProfile(const JumpFeel& feel = {});

/// The platform game of 1985, by tables of public disassemblies: NTSC, 60.0988 ticks per second, 16 pixels per metre,
/// all speeds multiples of 1/4096 pixel per tick. Step it by tickOf1985. It swims by that game's strokes. Tests:
/// [arcade], "walking takes 41 ticks to full speed, running 45"
PlatformProfile profile1985();
inline constexpr double tickOf1985 = 1 / 60.0988;  ///< [s]
inline constexpr double entryMove1985 = 0.5;       ///< PlatformInput::move of an automatic entry: 0Ch of 18h [-]

/// Throws std::invalid_argument with the field, the value and what was expected; field is the name of the structure.
void validate(const PlatformProfile& profile, const std::string& field);

}  // namespace plumb
