// SPDX-License-Identifier: MIT
// What moves a body of a scene otherwise than Newton would? As data, so that it can stand in a file.
#pragma once
#include <string>
#include <variant>
#include <vector>

#include <plumb/movers/grid_direction.h>
#include <plumb/movers/path_mover.h>
#include <plumb/shapes/tile_map.h>

namespace plumb::compare {

/// Along straight lines through its points, or a spline.
struct PathMotion {
    std::vector<Vec2> points{};  ///< of the body's origin; 2 or more [m]
    bool spline = false;
    bool closed = false;      ///< back to the first point
    double delay = 0;         ///< it rests so long first, >= 0 [s]
    double speed = 1;         ///< the highest, > 0 [m/s]
    double acceleration = 1;  ///< with easing "acceleration", > 0 [m/s^2]
    Easing easing = Easing::None;
    PathRepeat repeat = PathRepeat::Once;
};

/// What takes a slider's place in an engine that has no such movers?
enum class StandIn {
    Kinematic,  ///< a kinematic body as it is: it goes through what it meets
    Stopped,    ///< what comes nearest to it: a character mover where there is one, or a dynamic body told its velocity
};

/// Straight on at a speed, sliding along what it meets.
struct SlidingMotion {
    Vec2 velocity{0, 0};      ///< wanted [m/s]
    double pushStrength = 0;  ///< >= 0 [N]
    StandIn standIn = StandIn::Kinematic;
};

/// From tile to tile of a map.
struct GridMotion {
    std::string map{};  ///< the name of a body whose first shape is a tile map
    Cell cell{};        ///< in which it starts
    Direction heading = Direction::Right;
    double speed = 5;                ///< > 0 [tiles/s]
    std::vector<Direction> turns{};  ///< each wanted from when the one before was taken, round and round
};

enum class PlatformStyle {
    Modern,
    Of1985,  ///< at 60.0988 Hz
};

/// What a player holds from a time on.
struct PlatformCue {
    double time = 0;  ///< [s]
    double move = 0;  ///< -1 to 1 [-]
    bool run = false;
    bool jump = false;
};

/// Runs and jumps as a profile has it.
struct PlatformMotion {
    PlatformStyle profile = PlatformStyle::Modern;
    std::vector<PlatformCue> cues{};  ///< in the order of their times
};

/// To and fro about where it starts: by amplitude times sin(rate t).
struct SwingMotion {
    Vec2 amplitude{1, 0};  ///< [m]
    double rate = 1;       ///< > 0 [rad/s]
};

using MoverMotion = std::variant<PathMotion, SlidingMotion, GridMotion, PlatformMotion, SwingMotion>;

struct SceneMover {
    std::string name{};  ///< unique in the scene
    std::string body{};  ///< the name of a kinematic body
    MoverMotion motion{};
};

}  // namespace plumb::compare
