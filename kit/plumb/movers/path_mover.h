// SPDX-License-Identifier: MIT
// Where is an object that moves along a path, at any time?
#pragma once
#include <cstdint>
#include <vector>

#include <plumb/movers/path_shape.h>
#include <plumb/movers/path_timing.h>

namespace plumb {

enum class PathRepeat : std::uint8_t {
    Once,          ///< and stays at the end
    Loop,          ///< repeats; the path must be closed
    BackAndForth,  ///< reverses at both ends
};

/// A pause on the path. With easing, the object slows down before it and speeds up after it.
struct PathStop {
    double along = 0;  ///< from 0 to the path's length [m]
    double pause = 0;  ///< >= 0 [s]
};

struct PathMoverDef {
    MotionPath path;
    PathTiming timing = {};
    PathRepeat repeat = PathRepeat::Once;
    std::vector<PathStop> stops = {};  ///< in order of distance along the path, no two at one place
};

struct PathState {
    Vec2 position{0, 0};   ///< [m]
    Vec2 tangent{1, 0};    ///< direction of the path there, also on the way back [-]
    Vec2 velocity{0, 0};   ///< the tangent times the rate of change of along [m/s]
    double along = 0;      ///< [m]
    std::int64_t lap = 0;  ///< completed laps; forth and back is one
    bool finished = false;
};

struct PathPose {
    Vec2 position{0, 0};  ///< [m]
    double angle = 0;     ///< [rad]
};

/// Each result is a function of time alone: nothing accumulates, and after a million laps it is on its path as on the
/// first. Only its phase is rounded, by 2^-52 of the time at most. Tests: "a million laps later ...", "back and forth
/// is the same there as back ..."
class PathMover {
public:
    /// Throws std::invalid_argument naming the field.
    explicit PathMover(PathMoverDef def);

    /// The state at a time since the start [s]. Where the velocity jumps it is that after the jump. Throws
    /// std::invalid_argument on a time that is negative, not finite, or more than 2^53 laps long.
    PathState at(double time) const;
    PathState atTick(std::int64_t tick, double dt) const { return at(static_cast<double>(tick) * dt); }

    /// The target for a kinematic body before the step from tick to tick + 1: body.moveTo(position, angle, dt). The
    /// angle is that of the tangent, plus whole turns to be as near as possible to the body's own angle; for a body
    /// that should not turn, give moveTo another angle.
    PathPose poseAfter(std::int64_t tick, double dt, double angle = 0) const;

    double period() const { return period_; }  ///< of one lap, including its pauses [s]
    const PathMoverDef& def() const { return def_; }

private:
    /// A motion from one place to another, or a pause.
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
