// SPDX-License-Identifier: MIT
// What does a joint connect, and which conditions does it set? It is data, so that one piece of code solves
// every kind of joint, and several joints of the same kind at a time.
#pragma once
#include <algorithm>
#include <array>

#include <plumb/dynamics/joint_def.h>
#include <plumb/dynamics/joints/joint_end.h>
#include <plumb/dynamics/joints/lanes/island_shape.h>

namespace plumb {

/// The bound for a force or torque. A value larger than any world could need counts as unlimited, so that no number
/// overflows.
inline double boundOf(double force) {
    constexpr double most = 1e40;
    return force < most ? force : unlimited;
}

inline constexpr std::size_t maxRows = 3, maxLinks = 2, maxEnds = 4;

/// One condition. The coordinate q [m or rad] is B's place along the axis, less the origin.
struct RowForm {
    RowAxis axis = RowAxis::Turning;
    Vec2 direction{0, 0};  ///< World: the axis; OnA: the axis in A's frame; Missing: B's wanted velocity in A's frame
    double origin = 0;     ///< [m or rad]
    bool holds = true;     ///< keeps q at 0; else the row has a drive, a spring and a limit, each of which may be none
    bool bounded = false;  ///< the spring's force is bounded by maxForce, and there is no drive
    double speed = 0;      ///< of the drive [m/s or rad/s]
    double rate = 0;       ///< by how much the drive's speed falls with q, or, if Missing, with B's place [1/s]
    double maxForce = 0;   ///< of the drive [N or N m]
    Limit limit{-unlimited, unlimited};  ///< of q
    Spring spring{0, 0};
    double springRest = 0;  ///< q at which the spring gives no force [m or rad]

    bool isSpring() const { return spring.stiffness > 0 || spring.damping > 0; }
};

/// The part of its curve on which a row was last (see lanes/island_curve_wide.h).
enum class RowState : std::uint8_t { AtTarget, AtLow, AtHigh, AtLowerStop, AtUpperStop };

/// A gear and a pulley have two links, and one row: the sum of the first link's coordinate and ratio times the
/// second's.
struct JointForm {
    std::size_t links = 1, rows = 0;
    std::array<AnchorPair, maxLinks> link;
    std::array<RowForm, maxRows> row;
    RowAxis secondAxis = RowAxis::Turning;  ///< of the second link
    Vec2 secondDirection{0, 0};
    double ratio = 1;
    bool turnsOnly = false;  ///< its load has no lever arm: a gear
    /// The joint's coordinate: what users ask for, and gears connect.
    RowForm measured{.axis = RowAxis::World};

    explicit JointForm(const AnchorPair& anchors) : link{anchors, AnchorPair{}} {}
    RowForm& add(RowAxis axis, const Vec2& direction = Vec2(0, 0)) {
        RowForm& added = row[rows++];
        added.axis = axis;
        added.direction = direction;
        return added;
    }
    /// A row that does not hold.
    RowForm& addFree(RowAxis axis, const Vec2& direction = Vec2(0, 0)) {
        RowForm& added = add(axis, direction);
        added.holds = false;
        return added;
    }
    /// With the coordinate as its only row.
    JointForm ofCoordinate() const {
        JointForm form = *this;
        form.row[0] = measured;
        form.rows = 1;
        return form;
    }
    bool hasSpring() const {
        return std::any_of(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(rows),
                           [](const RowForm& one) { return one.isSpring(); });
    }
    bool springsOnlyTurn() const {
        return links == 1 &&
               std::all_of(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(rows),
                           [](const RowForm& one) { return one.axis == RowAxis::Turning || !one.isSpring(); });
    }
    void holdPoint() {
        add(RowAxis::World, Vec2(1, 0));
        add(RowAxis::World, Vec2(0, 1));
    }
};

}  // namespace plumb
