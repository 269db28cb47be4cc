// SPDX-License-Identifier: MIT
// Where does the textbook say a scene's bodies are at time t?
#pragma once
#include <vector>

#include <compare/engine/engine.h>
#include <compare/scene/scene.h>

namespace plumb::compare {

/// The state of each body of the scene, in its order, at t >= 0 [s]. All numbers of a state are NaN for a body the
/// closed form says nothing of, and for every body when there is no closed form or t lies past its until.
/// Throws std::invalid_argument when a motion names a body the scene does not have, and Unsupported where one cannot be
/// worked out of the scene's numbers. For many times, work the closed form out first: see worked_out.h.
/// At the instant of an impact the state is that just after it.
std::vector<BodyState> closedFormStates(const Scene& scene, double t);

}  // namespace plumb::compare
