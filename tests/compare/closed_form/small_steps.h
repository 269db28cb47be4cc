// SPDX-License-Identifier: MIT
// Where do small steps say that a scene's bodies go? Written for tests alone, and shares no code with closed forms.
#pragma once
#include <vector>

#include <compare/engine/engine.h>

namespace plumb::compare {

/// States at each of the times, which grow [s], in the order of the scene's bodies. The classical method of Runge and
/// Kutta of the fourth order on the forces of what the scene has: gravity, damping, fields, hinges and rods (as the one
/// angle that they leave), springs, ropes and gears. Impacts of discs and blocks with faces, and of discs, are found by
/// halving the step. Knows no more than the built-in scenes need. Bodies that it does not move keep their start.
std::vector<std::vector<BodyState>> smallSteps(const Scene& scene, const std::vector<double>& times);

}  // namespace plumb::compare
