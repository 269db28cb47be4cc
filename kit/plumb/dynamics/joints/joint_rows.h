// SPDX-License-Identifier: MIT
// Which conditions does a joint set for the velocities of its bodies?
//
// A row has the speed v = sum over its ends of (x, y, turn) . (vx, vy, w), and applies (x, y, turn) times its impulse L
// to each end. Its condition is L = impulse of a spring - d v + the value of its curve at v. The curve falls as v
// grows; the rows of a hinge, a motor and a limit are each parts of it:
//
//      L |      lower stop
//        |        |
//   high |        +------.          v below the target: the motor's greatest impulse
//        |               | target
//    low |               '------.   v above it: the greatest impulse the other way
//        |                      |
//        +----------------------+--- v
//                       upper stop
//
// A damper c removes the share 1 - exp(-c w h / 2) of v in half a sub-step h, if nothing else acts. w is the effective
// inverse mass, the change of v by a unit of L. So d = (exp(c w h / 2) - 1) / w, for the v after it. This is the half
// after a sub-step; in the half before it, the damper acts by the speed at the start of the sub-step, as a known
// impulse. Source: the speed at which a joint is held, as a complementarity problem: Murty, "Linear complementarity",
// 1988.
#pragma once
#include <array>
#include <limits>

#include <plumb/dynamics/joint_def.h>
#include <plumb/dynamics/joints/joint_form.h>
#include <plumb/math/detail/mat3.h>

namespace plumb {

struct JointRow {
    std::array<Vec3, 2> at{};                   ///< of two ends: x, y [-], turn [m]; for a turning row 0, 0, [-]
    double target = 0;                          ///< [m/s or rad/s]
    double low = -unlimited, high = unlimited;  ///< [N s or N m s]
    double lowerStop = -unlimited, upperStop = unlimited;  ///< [m/s or rad/s]
    bool holds = true;     ///< keeps v at the target with any impulse; has no drive and no stops
    double push = 0;       ///< of a spring [N s or N m s]
    double dampPush = 0;   ///< the part of push that is a damper's [N s or N m s]
    double damper = 0;     ///< c h / 2 [N s^2/m or N m s^2]
    bool bounded = false;  ///< low and high bound spring and damper; no target, no stops
};

/// The part of its curve on which a row was last.
enum class RowState : std::uint8_t { AtTarget, AtLow, AtHigh, AtLowerStop, AtUpperStop };

struct JointRows {
    std::size_t count = 0, ends = 2;
    std::array<BodyIndex, maxEnds> body{};
    std::array<JointRow, maxRows> row;
    std::array<Vec3, 2> far{};  ///< of the third and fourth end, of a joint with a single row
    std::array<Vec2, 2> arm{Vec2{0, 0},
                            Vec2{0, 0}};  ///< of the first two ends: to the point where the force is taken to act [m]

    const Vec3& at(std::size_t r, std::size_t end) const { return end < 2 ? row[r].at[end] : far[end - 2]; }
    JointRow& add() { return row[count++] = JointRow{}; }
    bool allHold() const {
        for (std::size_t r = 0; r < count; ++r)
            if (!row[r].holds) return false;
        return true;
    }
};

/// The springs of a joint, as they act on the bodies at its ends.
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

/// The inputs with which a joint computes its rows.
struct JointPass {
    double step = 0;         ///< h [s]
    bool correct = true;     ///< true: before the sub-step, which removes errors; false: after it, only velocities
    double rate = 0;         ///< share of an error to remove per time [1/s]
    double fastest = 0;      ///< greatest speed at which an error is removed [m/s]
    double springShare = 1;  ///< of springs' stiffness (see joint_springs.h)
};

/// The coordinate whose rate is a row's v: now, and after the coming sub-step at constant velocities.
struct PredictedCoordinate {
    double now = 0, later = 0;  ///< [m or rad]
};

/// A row for B's anchor along an axis that is fixed to A.
JointRow rowAlong(const Vec2& axis, const Ends& ends);
/// A row for B's angle less A's angle.
JointRow rowTurning();
/// The speed v of a row with two ends.
double speedOf(const JointRow& row, const Ends& ends);
/// The same at the spins with which endAfter predicts: the speed that belongs to a predicted coordinate.
double speedAhead(const JointRow& row, const Ends& ends, double h);
/// The speed v of any row, at the bodies' present velocities within a step.
double speedOf(const JointRows& rows, std::size_t row, const BodyStore& bodies);
/// Clears the rows and sets two ends.
void start(JointRows& rows, const Ends& ends);
/// The ends after the sub-step, if the pass corrects errors; otherwise they are not needed, and now is returned.
inline Ends ahead(const Ends& now, const JointPass& pass) {
    return pass.correct ? after(now, pass.step) : now;
}

/// Keeps the coordinate at 0. Removes the present error at the pass's rate, and the whole error that the sub-step would
/// add, to any order.
void hold(JointRow& row, const PredictedCoordinate& predicted, double speed, const JointPass& pass);
/// Keeps the coordinate within a limit. The row no longer holds a target, except by its motor.
void keepWithin(JointRow& row, const Limit& limit, const PredictedCoordinate& predicted, double speed,
                const JointPass& pass);
/// The bound for a force or torque. A value larger than any world could need counts as unlimited, so that no number
/// overflows.
double boundOf(double force);
/// Drives the row at a speed with at most this force or torque; 0: no drive.
void drive(JointRow& row, double speed, double force, const JointPass& pass);

/// holdRow adds one held row; holdPoint adds two rows that hold the anchors together.
void holdRow(JointRows& rows, const JointRow& row, const PredictedCoordinate& predicted, const Ends& now,
             const JointPass& pass);
void holdPoint(JointRows& rows, const Ends& now, const Ends& later, const JointPass& pass);

/// Adds a spring with the given stretch to a row, in addition to its drive and limits.
void pull(JointRow& row, const Spring& spring, double stretch, const JointPass& pass);
/// Adds a spring to a load. heldTurn: the joint prevents turning, so the spring cannot turn the bodies.
void addLoad(SpringLoad& load, const JointRow& row, const Spring& spring, double stretch, bool heldTurn = false);

}  // namespace plumb
