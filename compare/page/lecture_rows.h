// SPDX-License-Identifier: MIT
// Which formulas of a first lecture are compared with the engines?
#pragma once
#include <string>
#include <vector>

#include <compare/scene/scene.h>

namespace plumb::compare {

struct LectureRow {
    std::string label;  ///< the case, and what is measured in it
    Scene scene;        ///< a built-in scene with other numbers; its answer is the one query that is measured
};

/// The built-in scenes that the rows are made from.
const std::vector<std::string>& lectureScenes();

/// The period of a pendulum for seven amplitudes; the range of a throw for five angles, without drag and with it; the
/// time to fall in Atwood's machine for three ratios of masses.
std::vector<LectureRow> lectureRows();

}  // namespace plumb::compare
