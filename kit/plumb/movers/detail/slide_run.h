// SPDX-License-Identifier: MIT
// How does a body move in one tick: carried, pushed aside, walking, flying?
#pragma once
#include <plumb/movers/detail/slide_probe.h>

namespace plumb::detail {

/// The least upward component of a floor's normal; above 1 for a floating body. At an edge, the normal depends on
/// rounding of the position: an edge at a skin's distance is hit up to sqrt(2 skin rounding) too early or too late,
/// which is an angle of sqrt(2 rounding / skin) [-].
double leastFloorRise(const SlideSettings& settings, const Vec2& position);

/// The state of one tick of a body, so far.
struct SlideRun {
    World& world;
    const SlideSettings& settings;  ///< up has length 1
    SlideProbe probe;
    double dt;
    Vec2 position;          ///< so far [m]
    Vec2 velocity;          ///< relative to the carrier [m/s]
    Vec2 carry;             ///< velocity of the carrier, at the body [m/s]
    double pushLeft;        ///< impulse that may still be applied in this tick [N s]
    double leastFloorRise;  ///< of a floor's normal, upward component [-]
    Slide out;
    std::vector<BodyId> pushed = {};
    std::vector<Vec2> waypoints = {};  ///< end points of its straight motions
    Vec2 along{0, 0};                  ///< direction of the last walk, 0 when it did not walk

    Vec2 up() const { return settings.up; }
    Vec2 right() const { return {settings.up.y(), -settings.up.x()}; }
    bool floats() const { return settings.motionMode == MotionMode::Floating; }
    bool isFloor(const Vec2& normal) const;
    bool isCeiling(const Vec2& normal) const { return isFloor(-normal); }
    /// Direction along a floor, to the right or, with a side of -1, to the left.
    Vec2 alongFloor(const Vec2& normal, double side) const;
    SlideHit& recordHit(const CastHit& hit, SlideEffect effect);
    void touch(const Vec2& normal);  ///< marks a wall or a ceiling contact
};

/// Moving bodies push it out of their way. from: its position before the step, and before it was carried.
void pushAside(SlideRun& run, const Vec2& from);
void resolveOverlaps(SlideRun& run);

/// A wall or ceiling stops the body, or is pushed; the velocity into it is lost. Returns the velocity of its surface
/// afterwards [m/s].
Vec2 hitWall(SlideRun& run, const CastHit& hit, SlideEffect effect);

/// Moves along floors, by a length >= 0, up steps; stops at a wall.
void walk(SlideRun& run, double length, double side);
/// Moves through the air, slides along obstacles, and walks on where it lands.
void fly(SlideRun& run, Vec2 shift);
/// Moves down, or up by less than a skin, to a floor no deeper than reach, plus what the floor dropped over the
/// distance across that it walked; false when there is none.
bool snapToFloor(SlideRun& run, double reach, double across = 0);

/// Up over an edge not higher than height, then forward, onto a floor if toFloor is set. Subtracts the distance from
/// length.
bool stepOver(SlideRun& run, const CastHit& wall, const Vec2& along, double& length, double height, bool toFloor);
/// Moves sideways from under an edge, by as little as lets it rise by this.
bool nudgeAside(SlideRun& run, const CastHit& ceiling, double rise, double side);

struct SlidePush {
    double impulse = 0;  ///< applied over the step [N s]
    Vec2 surface{0, 0};  ///< the velocity of the hit surface afterwards [m/s]
};

/// Accelerates a dynamic body's surface, where it was hit, up to a velocity; with at most the remaining impulse, and
/// once per tick.
SlidePush push(SlideRun& run, const CastHit& hit, const Vec2& velocity);

}  // namespace plumb::detail
