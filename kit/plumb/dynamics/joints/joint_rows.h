// SPDX-License-Identifier: MIT
// What have the rows of joints given in a pass? It is told to those who keep accounts: the work of a joint cannot be
// seen from outside, because its impulses never become forces on the bodies' records.
#pragma once
#include <array>

#include <plumb/dynamics/joints/joint_form.h>
#include <plumb/math/detail/arrays.h>

namespace plumb {

struct IslandNumbers;
class StepObserver;

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

/// After a pass: tells the observer the rows of all joints of the active islands.
void reportRows(const IslandNumbers& numbers, StepObserver& observer);
/// The momentum that the joints of the active islands have given to their bodies. Among themselves they only pass it
/// on, so all of it came from fixed bodies [N s].
Vec2 givenMomentum(const IslandNumbers& numbers);

}  // namespace plumb
