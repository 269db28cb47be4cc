// SPDX-License-Identifier: MIT
// What does a joint ask of the velocities of its bodies?
//
// A row sees v = sum over its ends of (x, y, turn) . (vx, vy, w), and gives each end (x, y, turn) times its impulse L.
// What it wants is L = a spring's push - d v + what its curve says, falling as v grows, of which a hinge's rows, a
// motor's and a limit's are parts:
//
//      L |      lower stop
//        |        |
//   high |        +------.          v below the target: all that the motor has
//        |               | target
//    low |               '------.   v above it: all that it has, the other way
//        |                      |
//        +----------------------+--- v
//                       upper stop
//
// A damper c takes the part 1 - exp(-c w h / 2) of v in half a sub-step h, if nothing else acts, w what a unit of L
// does to v: d = (exp(c w h / 2) - 1) / w, for the v after it. It does so in the half after a sub-step; in the
// half before, it goes by the speed there was, and is a push. Source: the speed at which a joint is held, as a
// complementarity problem: Murty, "Linear complementarity", 1988.
#pragma once
#include <array>
#include <limits>

#include <plumb/dynamics/joint_def.h>
#include <plumb/dynamics/joints/joint_end.h>
#include <plumb/math/detail/mat3.h>

namespace plumb {

inline constexpr std::size_t maxRows = 3, maxEnds = 4;

struct JointRow {
    std::array<Vec3, 2> at{};                   ///< of two ends: x, y [-], turn [m], for what turns 0, 0, [-]
    double target = 0;                          ///< [m/s or rad/s]
    double low = -unlimited, high = unlimited;  ///< [N s or N m s]
    double lowerStop = -unlimited, upperStop = unlimited;  ///< [m/s or rad/s]
    bool holds = true;     ///< nothing but the target, with all the impulse that it takes
    double push = 0;       ///< of a spring [N s or N m s]
    double dampPush = 0;   ///< the part of push that is a damper's [N s or N m s]
    double damper = 0;     ///< c h / 2 [N s^2/m or N m s^2]
    bool bounded = false;  ///< low and high bound spring and damper; there is no target, and no stop
};

/// On which part of its curve a row was last.
enum class RowState : std::uint8_t { AtTarget, AtLow, AtHigh, AtLowerStop, AtUpperStop };

struct JointRows {
    std::size_t count = 0, ends = 2;
    std::array<BodyIndex, maxEnds> body{};
    std::array<JointRow, maxRows> row;
    std::array<Vec3, 2> far{};  ///< of the third and fourth end, which only a single row has
    std::array<Vec2, 2> arm{Vec2{0, 0},
                            Vec2{0, 0}};  ///< of the first two ends: to where the force counts as acting [m]
    double length = 0;                    ///< of what swings between two anchors; 0: nothing does [m]
    bool holdsPoint = false;              ///< keeps the anchors together

    const Vec3& at(std::size_t r, std::size_t end) const { return end < 2 ? row[r].at[end] : far[end - 2]; }
    JointRow& add() { return row[count++] = JointRow{}; }
    bool allHold() const {
        for (std::size_t r = 0; r < count; ++r)
            if (!row[r].holds) return false;
        return true;
    }
};

/// How springs load the bodies at a joint's ends.
struct SpringLoad {
    struct Row {
        std::array<Vec3, 2> at{};
        double stiffness = 0;  ///< [N/m or N m/rad]
        double stretch = 0;    ///< [m or rad]
    };
    std::size_t count = 0;
    std::array<Row, maxRows> row;
    double mostForce = unlimited;  ///< of all of them together [N]
};

/// What a joint is told when it is asked for its rows.
struct JointPass {
    double step = 0;         ///< h [s]
    bool correct = true;     ///< before the sub-step: errors are to be gone after it; after it: only velocities
    double rate = 0;         ///< share of an error that is to be gone [1/s]
    double fastest = 0;      ///< that an error is taken back [m/s]
    bool onlyHold = false;   ///< what is driven or sprung does nothing, but for its stops
    double springShare = 1;  ///< of springs' stiffness (see joint_springs.h)
};

/// A coordinate that a row is the rate of: now, and after the coming sub-step as things move now.
struct PredictedCoordinate {
    double now = 0, later = 0;  ///< [m or rad]
};

/// Along an axis that is fixed to A, where B's anchor is.
JointRow rowAlong(const Vec2& axis, const Ends& ends);
/// B's angle less A's.
JointRow rowTurning();
/// v of a row of two ends.
double speedOf(const JointRow& row, const Ends& ends);
/// v of any row, as the bodies move now within a step.
double speedOf(const JointRows& rows, std::size_t row, const BodyStore& bodies);
/// None yet, for two ends.
void start(JointRows& rows, const Ends& ends);
/// After the sub-step, if errors are to be gone by then; else nobody asks.
inline Ends ahead(const Ends& now, const JointPass& pass) {
    return pass.correct ? after(now, pass.step) : now;
}

/// Keeps the coordinate at 0: with the error it has now taken back at the pass's rate, and with all of what it would
/// otherwise gain in the sub-step, to any order.
void hold(JointRow& row, const PredictedCoordinate& predicted, double speed, const JointPass& pass);
/// Keeps the coordinate within a limit; what the row held is now only what its motor may do.
void keepWithin(JointRow& row, const Limit& limit, const PredictedCoordinate& predicted, double speed,
                const JointPass& pass);
/// More force or torque than anything in a world could need is no bound, so that its numbers cannot overflow.
double boundOf(double force);
/// Drives it at a speed with no more than a force or torque; 0: not at all.
void drive(JointRow& row, double speed, double force, const JointPass& pass);

/// Adds a row that is held, or two that hold the anchors together.
void holdRow(JointRows& rows, const JointRow& row, const PredictedCoordinate& predicted, const Ends& now,
             const JointPass& pass);
void holdPoint(JointRows& rows, const Ends& now, const Ends& later, const JointPass& pass);

/// Adds a spring to a row, stretched by so much, beside what else there is on it.
void pull(JointRow& row, const Spring& spring, double stretch, const JointPass& pass);
/// And to its load; heldTurn: the joint lets nothing turn, so that turning is no way out for the spring.
void addLoad(SpringLoad& load, const JointRow& row, const Spring& spring, double stretch, bool heldTurn = false);

}  // namespace plumb
