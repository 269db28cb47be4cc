// SPDX-License-Identifier: MIT
// What moves a body of a scene in a way other than Newton's laws? As data, so that it can be written in a file.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <plumb/dynamics/body_def.h>
#include <plumb/movers/grid_direction.h>
#include <plumb/movers/path_mover.h>
#include <plumb/shapes/tile_map.h>

namespace plumb::compare {

/// Along straight lines through its points, or a spline.
struct PathMotion {
    std::vector<Vec2> points{};  ///< of the body's origin; 2 or more [m]
    bool spline = false;
    bool closed = false;      ///< it goes back to the first point
    double delay = 0;         ///< it rests first for this time, >= 0 [s]
    double speed = 1;         ///< the highest speed, > 0 [m/s]
    double acceleration = 1;  ///< with easing "acceleration", > 0 [m/s^2]
    Easing easing = Easing::None;
    PathRepeat repeat = PathRepeat::Once;
};

/// The kit's mover for it. Throws std::invalid_argument where there is none.
PathMover pathMoverOf(const PathMotion& motion);

/// What replaces a slider in an engine that has no such movers?
enum class StandIn {
    Kinematic,  ///< an ordinary kinematic body: it goes through what it meets
    Stopped,    ///< a character mover if there is one, else a dynamic body whose velocity is set
};

/// Moves straight on at a speed, and slides along what it meets.
struct SlidingMotion {
    Vec2 velocity{0, 0};      ///< wanted [m/s]
    double pushStrength = 0;  ///< >= 0 [N]
    StandIn standIn = StandIn::Kinematic;
};

/// Moves from tile to tile of a map.
struct GridMotion {
    std::string map{};  ///< the name of a body whose first shape is a tile map
    Cell cell{};        ///< the cell in which it starts
    Direction heading = Direction::Right;
    double speed = 5;                ///< > 0 [tiles/s]
    std::vector<Direction> turns{};  ///< each turn is wanted after the one before; then again from the first
};

enum class PlatformStyle {
    Modern,
    Of1985,  ///< at 60.0988 Hz
};

/// What a player holds from a moment on.
struct PlatformCue {
    double time = 0;  ///< [s]
    double move = 0;  ///< -1 to 1 [-]
    bool run = false;
    bool jump = false;
};

/// Runs and jumps as the profile says.
struct PlatformMotion {
    PlatformStyle profile = PlatformStyle::Modern;
    std::vector<PlatformCue> cues{};  ///< in the order of their times
};

/// Swings about the place where it starts: by amplitude times sin(rate t).
struct SwingMotion {
    Vec2 amplitude{1, 0};  ///< [m]
    double rate = 1;       ///< > 0 [rad/s]
};

/// What does an agent want? See the kit's steering.
enum class Behaviour {
    Seek,    ///< at full speed to its target, and past it
    Flee,    ///< at full speed away from its target
    Arrive,  ///< to its target, and to rest there
    Pursue,  ///< to where it meets its target
    Evade,   ///< away from where its target would meet it
    Wander,  ///< anywhere, by chance
    Follow,  ///< along its points
    Avoid,   ///< to its target, round the circles of all other static bodies
    Flock,   ///< apart from, along with and close to all others that flock: separate, align and cohere, added
};

/// True if the behaviour is about another body.
bool needsTarget(Behaviour behaviour);

/// How far a body's circles reach from its origin: the radius of an agent. Empty if it has none [m].
std::optional<double> discRadius(const BodyDef& body);

/// Steers as an agent of the kit. All agents decide from where bodies are at the start of a step, then all move. What
/// stands in the way does not stop them.
struct SteeredMotion {
    Behaviour behaviour = Behaviour::Seek;
    std::string target{};        ///< the name of a body that is always there; none for wander, follow and flock
    Vec2 velocity{0, 0};         ///< at the start [m/s]
    double maxSpeed = 3;         ///< > 0 [m/s]
    double maxAcceleration = 6;  ///< > 0 [m/s^2]
    std::vector<Vec2> points{};  ///< with follow: of the path, 2 or more [m]
    bool closed = false;         ///< with follow: the path goes back to the first point
    double ahead = 1;            ///< with follow: how far along the path it looks, > 0 [m]
    std::uint64_t seed = 1;      ///< with wander: of its random numbers
};

using MoverMotion = std::variant<PathMotion, SlidingMotion, GridMotion, PlatformMotion, SwingMotion, SteeredMotion>;

struct SceneMover {
    std::string name{};  ///< unique in the scene
    std::string body{};  ///< the name of a kinematic body
    MoverMotion motion{};
};

}  // namespace plumb::compare
