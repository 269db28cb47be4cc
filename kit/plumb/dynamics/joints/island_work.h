// SPDX-License-Identifier: MIT
// What numbers does a pass over a island work on?
//
// They are kept from pass to pass for their memory, and because what the passes have in common need not be worked out
// again: between two moves, directions and masses are the same, and so is the matrix, but for rows that change.
#pragma once
#include <plumb/dynamics/joints/joint_curve.h>
#include <plumb/dynamics/joints/joint_store.h>
#include <plumb/math/detail/bytes_of.h>

namespace plumb {

struct IslandWork {
    // Of the joints
    std::vector<JointRows> rows, rowsBefore;  ///< of this pass and the one before
    std::vector<std::array<RowState, maxRows>> states;
    std::vector<std::array<RowEquation, maxRows>> equations;
    std::vector<Vec3> inverseMasses;  ///< what a unit impulse does to a row's speed
    std::vector<Vec3> impulses;       ///< in this pass
    std::vector<Vec3> compliances;    ///< of the rows in the matrix that was factored last; -1: not in it

    // Of the bodies
    std::vector<Vec3> masses;           ///< along x, y, turning; 0: nothing turns it
    std::vector<Vec3> massesBefore;     ///< in the matrix that was factored last
    std::vector<Vec3> stiffnessBefore;  ///< before this pass [N/m, N m/rad]
    std::vector<Vec3> before, after;    ///< velocities

    std::vector<Vec3> answer;  ///< of the bodies, then of the joints

    std::size_t bytes() const {
        return bytesOf(rows) + bytesOf(rowsBefore) + bytesOf(states) + bytesOf(equations) + bytesOf(inverseMasses) +
               bytesOf(impulses) + bytesOf(compliances) + bytesOf(masses) + bytesOf(massesBefore) +
               bytesOf(stiffnessBefore) + bytesOf(before) + bytesOf(after) + bytesOf(answer);
    }
};

}  // namespace plumb
