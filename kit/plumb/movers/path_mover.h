// SPDX-License-Identifier: MIT
// Where is a thing that goes along a path, at any time?
#pragma once
#include <cstdint>
#include <vector>

#include <plumb/movers/path_shape.h>
#include <plumb/movers/path_timing.h>

namespace plumb {

enum class PathRepeat : std::uint8_t {
    Once,          ///< and rests at the end
    Loop,          ///< round and round; the path must be closed
    BackAndForth,  ///< turning round at both ends
};

/// A rest on the way. With easing it slows down for it, and speeds up after.
struct PathStop {
    double along = 0;  ///< from 0 to the path's length [m]
    double pause = 0;  ///< >= 0 [s]
};

struct PathMoverDef {
    MotionPath path;
    PathTiming timing = {};
    PathRepeat repeat = PathRepeat::Once;
    std::vector<PathStop> stops = {};  ///< in their order along the path, no two at one place
};

struct PathState {
    Vec2 position{0, 0};   ///< [m]
    Vec2 tangent{1, 0};    ///< in which the path goes on there, also on the way back [-]
    Vec2 velocity{0, 0};   ///< the tangent times what the way along grows by in a second [m/s]
    double along = 0;      ///< [m]
    std::int64_t lap = 0;  ///< laps done; there and back again is one
    bool finished = false;
};

struct PathPose {
    Vec2 position{0, 0};  ///< [m]
    double angle = 0;     ///< [rad]
};

/// Each answer is a function of the time alone: nothing adds up, and after a million laps it is on its path as on the
/// first. Only its phase is rounded, by 2^-52 of the time at most. Tests: "a million laps later ...", "back and forth
/// is the same there as back ..."
class PathMover {
public:
    /// Throws std::invalid_argument naming the field.
    explicit PathMover(PathMoverDef def);

    /// At a time since its start [s]. Where the velocity jumps it is that of what follows. Throws std::invalid_argument
    /// on a time that is negative, not finite, or more than 2^53 laps long.
    PathState at(double time) const;
    PathState atTick(std::int64_t tick, double dt) const { return at(static_cast<double>(tick) * dt); }

    /// What a kinematic body must be told before the step from tick to tick + 1: body.moveTo(position, angle, dt). Its
    /// angle is the tangent's, by whole turns as near as can be to the body's own; who does not want to turn gives
    /// moveTo another.
    PathPose poseAfter(std::int64_t tick, double dt, double angle = 0) const;

    double period() const { return period_; }  ///< of one lap, its rests included [s]
    const PathMoverDef& def() const { return def_; }

private:
    /// A run from one place to another, or a rest.
    struct Leg {
        double start;  ///< in the lap [s]
        double from, to;
    };
    void addRun(double from, double to);
    void addRest(double at, double pause);
    void addWayBack();
    PathState stateIn(const Leg& leg, double time) const;

    PathMoverDef def_;
    std::vector<Leg> legs_;
    double period_ = 0;
};

}  // namespace plumb
