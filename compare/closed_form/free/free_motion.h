// SPDX-License-Identifier: MIT
// How do bodies go on that nothing holds, from impact to impact?
#pragma once
#include <string>
#include <vector>

#include <compare/closed_form/worked_motion.h>
#include <compare/scene/scene.h>

namespace plumb::compare {

/// The motions of those bodies of a scene whose closed form is a FreeMotion, in its order, worked out of the scene's
/// gravity, its uniform fields and linear air, their masses, materials, shapes and starts, and of what they may meet.
///   flights of constant acceleration, or DampedFlight or DragFall where the air holds what meets nothing
///   impacts with faces and corners that do not give way, and of discs with each other: Newton's law with the mixed
///   restitution, Coulomb's with the mixed friction; both bodies' masses and inertias share the impulse
///   on a face: sliding, on a belt too, rolling of discs, rest; a block that stands beyond its tipping angle falls over
/// Each event is solved for, so the motion is exact to rounding. Throws Unsupported, with the body and the reason,
/// where no formula is known here: a block that tips or lands turning, what touches two things at once, and the like.
/// Tests: tests/compare/closed_form/follows_test.cpp
std::vector<WorkedMotion> freeMotions(const Scene& scene);

}  // namespace plumb::compare
