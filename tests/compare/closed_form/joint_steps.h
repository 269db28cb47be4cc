// SPDX-License-Identifier: MIT
// Where do small steps say that bodies go which joints and fields hold? For tests alone; shares no code with closed
// forms.
#pragma once
#include <vector>

#include <compare/engine/engine.h>

namespace plumb::compare {

/// As smallSteps, of bodies that touch nothing: forces and constraints in one system of equations at each of the four
/// stages, M a = F + J^T f with J a = -(dJ/dt) v, and J by differences of the constraints themselves.
std::vector<std::vector<BodyState>> jointSteps(const Scene& scene, const std::vector<double>& times, double step);

/// The largest acceleration at the start of what is held so [m/s^2 or rad/s^2].
double startAcceleration(const Scene& scene);

}  // namespace plumb::compare
