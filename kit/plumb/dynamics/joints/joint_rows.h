// SPDX-License-Identifier: MIT
// What are those told who keep accounts of joints?
#pragma once
#include <array>

#include <plumb/dynamics/joints/joint_form.h>
#include <plumb/math/detail/arrays.h>

namespace plumb {

struct JointRow {
    std::array<Vec3, 2> at{};                   ///< of two ends: x, y [-], turn [m]; for a turning row 0, 0, [-]
    double low = -unlimited, high = unlimited;  ///< bounds of the drive's impulse [N s or N m s]
    bool holds = true;                          ///< it has no drive and no stops
    double push = 0;                            ///< of a spring [N s or N m s]
    double dampPush = 0;                        ///< the part of push that is a damper's [N s or N m s]
    bool bounded = false;                       ///< low and high bound spring and damper; no drive, no stops
};

struct JointRows {
    std::size_t count = 0, ends = 2;
    std::array<BodyIndex, maxEnds> body{};
    std::array<JointRow, maxRows> row;
    std::array<Vec3, 2> far{};  ///< of the third and fourth end, of a joint with a single row

    const Vec3& at(std::size_t r, std::size_t end) const { return end < 2 ? row[r].at[end] : far[end - 2]; }
    JointRow& add() { return row[count++] = JointRow{}; }
};

}  // namespace plumb
