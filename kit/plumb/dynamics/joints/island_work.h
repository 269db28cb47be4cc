// SPDX-License-Identifier: MIT
// What data does a pass over a joint island work on?
//
// The data is kept from pass to pass to reuse its memory, and to avoid computing the same values again: as long as no
// body moves, directions and masses stay the same, and so does the matrix, except for rows that change.
#pragma once
#include <plumb/dynamics/joints/joint_curve.h>
#include <plumb/dynamics/joints/joint_store.h>
#include <plumb/math/detail/bytes_of.h>

namespace plumb {

struct IslandWork {
    // One entry per joint
    std::vector<JointRows> rows, rowsBefore;  ///< of this pass and the one before
    std::vector<std::array<RowState, maxRows>> states;
    std::vector<std::array<RowEquation, maxRows>> equations;
    std::vector<Vec3> inverseMasses;  ///< effective inverse mass of each row
    std::vector<Vec3> impulses;       ///< in this pass
    std::vector<Vec3> compliances;    ///< of the rows in the last factored matrix; -1: row is not in it

    // One entry per body
    std::vector<Vec3> masses;           ///< along x, along y, moment of inertia; 0: it cannot turn
    std::vector<Vec3> massesBefore;     ///< in the last factored matrix
    std::vector<Vec3> stiffnessBefore;  ///< before this pass [N/m, N m/rad]
    std::vector<Vec3> before, after;    ///< velocities

    std::vector<Vec3> answer;  ///< solution: of the bodies, then of the joints

    std::size_t bytes() const {
        return bytesOf(rows) + bytesOf(rowsBefore) + bytesOf(states) + bytesOf(equations) + bytesOf(inverseMasses) +
               bytesOf(impulses) + bytesOf(compliances) + bytesOf(masses) + bytesOf(massesBefore) +
               bytesOf(stiffnessBefore) + bytesOf(before) + bytesOf(after) + bytesOf(answer);
    }
};

}  // namespace plumb
