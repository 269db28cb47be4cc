// SPDX-License-Identifier: MIT
// How is a body to slide, and what has come of it?
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <plumb/dynamics/world.h>

namespace plumb {

/// Which velocity of its floor a body keeps when it leaves it.
enum class PlatformOnLeave {
    AddVelocity,
    AddUpwardVelocity,  ///< as AddVelocity, but never downward
    DoNothing,
};

enum class MotionMode {
    Grounded,  ///< with floors, walls and ceilings
    Floating,  ///< for top-down games, or in space: everything is a wall, nothing carries
};

struct SlideSettings {
    MotionMode motionMode = MotionMode::Grounded;
    Vec2 up{0, 1};                             ///< not 0 [-]
    double maxFloorAngle = 0.785398163397449;  ///< above it is wall; 0 to below pi / 2; pi / 4 is still floor [rad]
    double floorSnapLength = 0.1;              ///< the floor is followed down as far as this, >= 0 [m]
    bool floorStopOnSlope = true;              ///< false: the displacement's downward component slides it down a slope
    bool floorConstantSpeed = true;            ///< true: same speed along a slope; false: same horizontal speed
    bool floorBlockOnWall = true;              ///< false: walking into a wall that leans away runs up it
    bool slideOnCeiling = true;                ///< false: hitting a ceiling stops a jump, and the body falls
    double wallMinSlideAngle = 0.2617993877991494;  ///< floating: a more head-on hit stops it; 0 to pi / 2 [rad]
    double stepHeight = 0;                          ///< climbs steps up to this height from floor to floor, >= 0 [m]
    double cornerCorrection = 0;                    ///< rising under an edge, it shifts sideways up to this, >= 0 [m]
    double ledgeNudge = 0;    ///< in the air, against an edge, it is lifted by up to this, >= 0 [m]
    double pushStrength = 0;  ///< on all dynamic bodies that it hits, together, >= 0 [N]
    double weight = 0;        ///< on the dynamic body that it stands on, >= 0 [N]
    PlatformOnLeave platformOnLeave = PlatformOnLeave::AddVelocity;
    std::uint64_t platformFloorLayers = ~std::uint64_t{0};  ///< floors of other categories do not carry
    double skin = 1e-3;                                     ///< distance kept to obstacles, > 0 [m]
    int maxSlides = 8;                                      ///< straight motions in one tick, >= 1 [-]
    double reach = 1;  ///< approaching kinematic bodies are detected within this plus its own motion, >= 0 [m]
};

struct SlideMotion {
    Vec2 velocity{0, 0};  ///< wanted; on a floor, relative to it; an upward one leaves the floor [m/s]
    double dt = 0;        ///< of the World::step that follows, > 0 [s]
    std::optional<Vec2> displacement = std::nullopt;  ///< wanted in this tick; if empty, velocity dt [m]
    bool dropThrough = false;                         ///< through the one-way floors that it stands on
    /// Bodies for which this function will be called later in the same tick: they are hit where they are now, and do
    /// not push. If they are not listed, they push with their velocity of the tick before.
    std::span<const BodyId> later = {};
};

enum class SlideEffect {
    Landed,    ///< on a floor
    Stopped,   ///< at a wall, or between two walls
    Slid,      ///< along it
    Pushed,    ///< a dynamic body, by impulse
    Stepped,   ///< up onto it
    Nudged,    ///< sideways past it, or up over its edge
    PushedBy,  ///< out of its way, or out of an overlap
};

/// A hit as in CastHit, and its effect.
struct SlideHit {
    ShapeId shape;
    std::optional<Cell> tile = std::nullopt;
    Vec2 point{0, 0};    ///< in the world [m]
    Vec2 normal{0, 1};   ///< from the obstacle to the body [-]
    double speed = 0;    ///< approach speed along the normal, >= 0 [m/s]
    double impulse = 0;  ///< given to a dynamic body in the step [N s]
    SlideEffect effect = SlideEffect::Slid;
};

/// A one-way shape; of a tile map, the row of one-way tiles to which this tile belongs.
struct OneWayFloor {
    ShapeId shape;
    std::optional<Cell> tile = std::nullopt;
};

struct TileTouch {
    ShapeId shape;  ///< the map
    Cell tile;
};

/// The result of a tick; the next tick needs it.
struct Slide {
    Vec2 velocity{0, 0};      ///< the rest of the wanted one; on a floor, relative to it and horizontal [m/s]
    Vec2 position{0, 0};      ///< where the body will be after World::step [m]
    Vec2 displacement{0, 0};  ///< from its present position, including what carried or pushed it [m]
    bool isOnFloor = false, isOnWall = false, isOnCeiling = false;  ///< for walls and ceilings: according to hits
    bool crushed = false;                      ///< a body that moves into it, or overlaps it, leaves it no way out
    Vec2 floorNormal{0, 1}, wallNormal{1, 0};  ///< of the floor and wall it touches [-]
    double floorAngle = 0;                     ///< of the floor, from the horizontal [rad]
    Vec2 platformVelocity{0, 0};               ///< of the floor, below it; if it left a floor, of that floor [m/s]
    std::vector<SlideHit> hits = {};           ///< in the order of time
    std::vector<TileTouch> hazards = {};       ///< all hazard tiles that it touched: during its motion, and at its end

    // For the next tick.
    std::optional<CastHit> floor = std::nullopt;  ///< the floor, as it was hit
    Vec2 anchor{0, 0};                            ///< where it stands, in the floor body's frame [m]
    Vec2 anchorAfter{0, 0};                       ///< where the step takes that point, in the world [m]
    std::vector<OneWayFloor> dropping = {};       ///< the floors it is falling through, until it is out of them
    bool hasEntered = false;                      ///< it has been inside of one of those since it dropped
};

}  // namespace plumb
