// SPDX-License-Identifier: MIT
// How does a body go through one tick: carried, pushed aside, walking, flying?
#pragma once
#include <plumb/movers/detail/slide_probe.h>

namespace plumb::detail {

/// Of the normal of a floor, upward; beyond 1 for who floats. What is met at an edge has a normal that roundings of the
/// place turn: an edge a skin away is met up to sqrt(2 skin rounding) too early or too late, which is sqrt(2 rounding /
/// skin) of an angle
/// [-].
double leastFloorRise(const SlideSettings& settings, const Vec2& position);

/// One tick of a body, as far as it has come.
struct SlideRun {
    World& world;
    const SlideSettings& settings;  ///< up has length 1
    SlideProbe probe;
    double dt;
    Vec2 position;          ///< so far [m]
    Vec2 velocity;          ///< against what carries it [m/s]
    Vec2 carry;             ///< of what carries it, where it is [m/s]
    double pushLeft;        ///< impulse that may still be given in this tick [N s]
    double leastFloorRise;  ///< of a floor's normal, upward [-]
    Slide out;
    std::vector<BodyId> pushed = {};
    std::vector<Vec2> places = {};  ///< between which it went straight on
    Vec2 along{0, 0};               ///< the way of the last stretch that it walked, 0 when it did not walk

    Vec2 up() const { return settings.up; }
    Vec2 right() const { return {settings.up.y(), -settings.up.x()}; }
    bool floats() const { return settings.motionMode == MotionMode::Floating; }
    bool isFloor(const Vec2& normal) const;
    bool isCeiling(const Vec2& normal) const { return isFloor(-normal); }
    /// Along a floor, to the right or, with a side of -1, to the left.
    Vec2 alongFloor(const Vec2& normal, double side) const;
    SlideHit& note(const CastHit& hit, SlideEffect effect);
    void touch(const Vec2& normal);  ///< tells that it is on a wall or a ceiling
};

/// What moves into it pushes it out of the way. from: where it was before the step, and before it was carried.
void pushAside(SlideRun& run, const Vec2& from);
void partOverlaps(SlideRun& run);

/// Something steeper than a floor, or a ceiling, stops it or is pushed; the velocity into it is lost. Gives the
/// velocity of its surface after that [m/s].
Vec2 meetWall(SlideRun& run, const CastHit& hit, SlideEffect effect);

/// Goes on along floors, by a length >= 0, up steps; stops at a wall.
void walk(SlideRun& run, double length, double side);
/// Goes through the air, slides along what it meets, and walks on where it lands.
void fly(SlideRun& run, Vec2 shift);
/// Down, or up by less than a skin, to a floor no deeper than reach, or than what the floor fell over the way across
/// that it walked; false when there is none.
bool settle(SlideRun& run, double reach, double across = 0);

/// Up over an edge not higher than height, then on, to a floor if there must be one. Takes what it went off the length.
bool stepOver(SlideRun& run, const CastHit& wall, const Vec2& along, double& length, double height, bool toFloor);
/// Aside from under an edge, by as little as lets it rise by this.
bool nudgeAside(SlideRun& run, const CastHit& ceiling, double rise, double side);

struct SlidePush {
    double impulse = 0;  ///< over the step [N s]
    Vec2 surface{0, 0};  ///< the velocity of what was met, there, after it [m/s]
};

/// Takes a dynamic body's surface, where it is met, up to a velocity; by at most what is left, and once in a tick.
SlidePush push(SlideRun& run, const CastHit& hit, const Vec2& velocity);

}  // namespace plumb::detail
