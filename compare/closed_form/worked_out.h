// SPDX-License-Identifier: MIT
// What is the closed form of a scene once its numbers are taken from the scene's bodies, joints and fields?
#pragma once
#include <compare/scene/scene.h>

namespace plumb::compare {

/// Does each motion hold its numbers itself?
bool isWorkedOut(const ClosedForm& form);

/// The scene's closed form with each motion that holds names in the place of numbers worked out, in the scene's order,
/// and with the earliest of its own until and those that came out on the way. Those that hold numbers stay as they are.
/// The scene must have a closed form, and be valid. Throws Unsupported, naming the body and the reason, where no
/// formula is known: "closedForm.bodies.block: it tips over, and no formula is known here". Test:
/// tests/compare/closed_form/follows_test.cpp
ClosedForm workedOut(const Scene& scene);

}  // namespace plumb::compare
