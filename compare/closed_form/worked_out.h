// SPDX-License-Identifier: MIT
// What is the closed form of a scene after its numbers are taken from the scene's bodies, joints and fields?
#pragma once
#include <compare/scene/scene.h>

namespace plumb::compare {

/// Does each motion hold its numbers itself?
bool isWorkedOut(const ClosedForm& form);

/// The scene's closed form. Each motion that holds names is replaced by one with numbers, in the scene's order; motions
/// that hold numbers stay as they are. Its until is the earliest of its own and those found for the motions.
/// The scene must have a closed form, and be valid. Throws Unsupported, naming the body and the reason, if no formula
/// is known: "closedForm.bodies.block: it tips over, and no formula is known here". Test:
/// tests/compare/closed_form/follows_test.cpp
ClosedForm workedOut(const Scene& scene);

}  // namespace plumb::compare
