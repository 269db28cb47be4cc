// SPDX-License-Identifier: MIT
// Where does the textbook say a scene's bodies are at time t?
#pragma once
#include <vector>

#include <compare/scene/state.h>
#include <compare/scene/scene.h>

namespace plumb::compare {

/// The state of each body of the scene, in its order, at t >= 0 [s]. All numbers of a state are NaN for a body that the
/// closed form does not describe, and for every body if there is no closed form or t is after its until.
/// Throws std::invalid_argument if a motion names a body that the scene does not have, and Unsupported if a motion
/// cannot be computed from the scene's numbers. For many times, work out the closed form first: see worked_out.h.
/// At the instant of an impact the state is the one just after it.
std::vector<BodyState> closedFormStates(const Scene& scene, double t);

}  // namespace plumb::compare
