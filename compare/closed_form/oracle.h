// SPDX-License-Identifier: MIT
// Where does the textbook say a scene's bodies are at time t?
#pragma once
#include <vector>

#include <compare/scene/scene.h>
#include <compare/scene/state.h>

namespace plumb::compare {

/// Does each motion hold its numbers itself?
bool isWorkedOut(const ClosedForm& form);

/// The scene's closed form. Each motion that holds names is replaced by one with numbers, in the scene's order; motions
/// that hold numbers stay as they are. Its until is the earliest of its own and those found for the motions.
/// The scene must have a closed form, and be valid. Throws Unsupported, naming the body and the reason, if no formula
/// is known: "closedForm.bodies.block: it tips over, and no formula is known here". Test:
/// tests/compare/closed_form/follows_test.cpp
ClosedForm workedOut(const Scene& scene);

/// The state of each body of the scene, in its order, at t >= 0 [s]. A static body is where it starts. All numbers of a
/// state are NaN for another body that the closed form does not describe, and for every body if there is no closed form
/// or t is after its until.
/// Throws std::invalid_argument if a motion names a body that the scene does not have, and Unsupported if a motion
/// cannot be computed from the scene's numbers. For many times, work out the closed form first: see workedOut.
/// At the instant of an impact the state is the one just after it.
std::vector<BodyState> closedFormStates(const Scene& scene, double t);

}  // namespace plumb::compare
