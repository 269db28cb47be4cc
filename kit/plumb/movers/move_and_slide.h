// SPDX-License-Identifier: MIT
// Where does a body that a game moves come to, among what it meets, pushes, stands on and is pushed by?
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <plumb/dynamics/world.h>

namespace plumb {

/// What of the velocity of what it stood on goes with a body that leaves it.
enum class PlatformOnLeave {
    AddVelocity,
    AddUpwardVelocity,  ///< as AddVelocity, but never downward
    DoNothing,
};

enum class MotionMode {
    Grounded,  ///< with floors, walls and ceilings
    Floating,  ///< seen from above, or in space: all is wall, nothing carries
};

struct SlideSettings {
    MotionMode motionMode = MotionMode::Grounded;
    Vec2 up{0, 1};                             ///< not 0 [-]
    double maxFloorAngle = 0.785398163397449;  ///< steeper is a wall; 0 to below pi / 2; pi / 4 is still floor [rad]
    double floorSnapLength = 0.1;              ///< as far down as this the floor is followed, >= 0 [m]
    bool floorStopOnSlope = true;              ///< false: the displacement's downward part slides it down a slope
    bool floorConstantSpeed = true;            ///< as fast on a slope as on the flat; false: as fast across
    bool slideOnCeiling = true;                ///< false: who hits a ceiling in a jump stops, and falls
    double wallMinSlideAngle = 0.2617993877991494;  ///< floating: nearer head on it stops; 0 to pi / 2 [rad]
    double stepHeight = 0;                          ///< as high as this it climbs from floor to floor, >= 0 [m]
    double cornerCorrection = 0;                    ///< rising under an edge, it shifts aside by up to this, >= 0 [m]
    double ledgeNudge = 0;    ///< in the air, against an edge, it is lifted by up to this, >= 0 [m]
    double pushStrength = 0;  ///< on the dynamic bodies that it meets together, >= 0 [N]
    double weight = 0;        ///< on the dynamic body on which it stands, >= 0 [N]
    PlatformOnLeave platformOnLeave = PlatformOnLeave::AddVelocity;
    std::uint64_t platformFloorLayers = ~std::uint64_t{0};  ///< floors of other categories carry nobody along
    double skin = 1e-3;                                     ///< kept to what is met, > 0 [m]
    int maxSlides = 8;                                      ///< ways in one tick, >= 1 [-]
    double reach = 1;  ///< kinematic bodies are seen coming from as far as this and its own way, >= 0 [m]
};

struct SlideMotion {
    Vec2 velocity{0, 0};  ///< wanted; on a floor, against that floor; up leaves the floor [m/s]
    double dt = 0;        ///< of the World::step that follows, > 0 [s]
    std::optional<Vec2> displacement = std::nullopt;  ///< wanted in this tick; without, velocity dt [m]
    bool dropThrough = false;                         ///< through the one-way floors that it stands on
    /// Of the bodies that this is called for in a tick, those for which it is yet to be: they are met where they are
    /// now, and do not push. Without, they push on by the velocity of the tick before.
    std::span<const BodyId> later = {};
};

enum class SlideEffect {
    Landed,    ///< on a floor
    Stopped,   ///< at a wall, or between two
    Slid,      ///< along it
    Pushed,    ///< a dynamic body, by impulse
    Stepped,   ///< up onto it
    Nudged,    ///< aside of it, or up over its edge
    PushedBy,  ///< out of its way, or out of where it overlapped
};

/// As a CastHit; and how it came to that.
struct SlideHit {
    ShapeId shape;
    std::optional<Cell> tile = std::nullopt;
    Vec2 point{0, 0};    ///< in the world [m]
    Vec2 normal{0, 1};   ///< from what was met to the body [-]
    double speed = 0;    ///< at which they came together along it, >= 0 [m/s]
    double impulse = 0;  ///< given to a dynamic body in the step [N s]
    SlideEffect effect = SlideEffect::Slid;
};

/// A one-way shape; of a tile map, the row of one-way tiles to which this one belongs.
struct OneWayFloor {
    ShapeId shape;
    std::optional<Cell> tile = std::nullopt;
};

struct TileTouch {
    ShapeId shape;  ///< the map
    Cell tile;
};

/// What came of a tick; the next tick needs it.
struct Slide {
    Vec2 velocity{0, 0};      ///< what is left of the wanted one; on a floor, against that floor and level [m/s]
    Vec2 position{0, 0};      ///< where the body will be after World::step [m]
    Vec2 displacement{0, 0};  ///< from where it is now, what carried or pushed it included [m]
    bool isOnFloor = false, isOnWall = false, isOnCeiling = false;  ///< as hits tell, also of what pushed it
    bool crushed = false;                      ///< what moves into it, or lay over it, leaves it no way out
    Vec2 floorNormal{0, 1}, wallNormal{1, 0};  ///< where it is on one [-]
    double floorAngle = 0;                     ///< of the floor, from the level [rad]
    Vec2 platformVelocity{0, 0};               ///< of the floor, under it; where it left one, of that [m/s]
    std::vector<SlideHit> hits = {};           ///< in the order in which they came
    std::vector<TileTouch> hazards = {};       ///< all hazard tiles that it touched: on its way, and where it stands

    // For the next tick.
    std::optional<CastHit> floor = std::nullopt;  ///< what it stands on, as it was met
    Vec2 anchor{0, 0};                            ///< where it stands, in that body's frame [m]
    Vec2 anchorAfter{0, 0};                       ///< where the step takes that place, in the world [m]
    std::vector<OneWayFloor> dropping = {};       ///< it falls through these, until it is out of them
    bool hasEntered = false;                      ///< it has been in one of those since it dropped
};

/// Gives a kinematic body the velocity with which the next World::step(motion.dt) takes it as far as it can go; call it
/// before each. It stops a skin short of what it meets, slides along it, follows floors up, over and down, and pushes
/// dynamic bodies by at most pushStrength dt, no faster than it goes itself: m a = pushStrength - friction.
/// Kinematic bodies are met where the coming step takes them: they carry whoever stands on them, and push others.
/// A body on another's floor keeps its place on it to rounding, as its place is kept in the other's frame; a floor that
/// was set elsewhere, farther than its velocity explains, takes nobody along. Who stood on a body that was removed
/// leaves it with its velocity.
/// Of movers on movers, call it for who carries before who rides: the rider goes by the velocity given in this tick.
/// And tell who comes later, or a mover that has turned around is still met as going on: its velocity is of the tick
/// before. One-way shapes are solid from their open side only, unless overlapped. Of a tile map's one-way tiles those
/// whose tops join end to end, sideways, are one floor; who drops through one meets the next. Its own sensors meet
/// nothing. last is what this gave in the tick before, or Slide{} at first, or after a jump to elsewhere. Throws
/// std::invalid_argument for a stale id, a body that is not kinematic, or values out of range. Tests: [movers], "a
/// crate under a push F and friction mu m g gains (F - mu m g) / m a second"
Slide moveAndSlide(World& world, BodyId body, const SlideMotion& motion, const SlideSettings& settings = {},
                   const Slide& last = {});

/// Throws std::invalid_argument naming the field, the value and what was wanted; field is the name of the whole.
void validate(const SlideSettings& settings, const std::string& field);

}  // namespace plumb
