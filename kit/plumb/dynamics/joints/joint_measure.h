// SPDX-License-Identifier: MIT
// How does a joint stand between two steps?
#pragma once
#include <plumb/dynamics/joints/joint_form.h>
#include <plumb/math/detail/arrays.h>

namespace plumb {

/// A row at the bodies' present places and velocities.
struct MeasuredRow {
    double coordinate = 0;     ///< q [m or rad]
    double speed = 0;          ///< [m/s or rad/s]
    std::array<Vec3, 2> at{};  ///< a unit impulse of the row, as it acts on the ends of the first link
};

MeasuredRow measure(const JointForm& form, const RowForm& row, const BodyStore& bodies);

/// How far the anchors are from where they are held, or beyond their limits [m].
double errorOf(const JointForm& form, const BodyStore& bodies);
/// The same of the angle [rad].
double angleErrorOf(const JointForm& form, const BodyStore& bodies);

/// How fast the links of a joint that holds something turn, as seen from their own size [rad/s].
double turningOf(const JointForm& form, const BodyStore& bodies);

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

SpringLoad springLoadOf(const JointForm& form, const BodyStore& bodies);

}  // namespace plumb
