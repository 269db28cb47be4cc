// SPDX-License-Identifier: MIT
// How do bodies that nothing holds move from impact to impact?
#pragma once
#include <string>
#include <vector>

#include <compare/closed_form/motion.h>
#include <compare/scene/scene.h>

namespace plumb::compare {

/// The motions of those bodies of a scene whose closed form is a FreeMotion, in its order. They are computed from the
/// scene's gravity, its uniform fields and linear air, and from the masses, materials, shapes and starts of the bodies
/// and the obstacles that they may meet.
///   flights of constant acceleration; a DampedFlight or DragFall if there is drag and the body meets nothing
///   impacts with faces and corners that do not give way, and of discs with each other: Newton's law with the mixed
///   restitution, Coulomb's with the mixed friction; both bodies' masses and inertias share the impulse
///   on a face: sliding, on a belt too, rolling of discs, rest; a block that stands beyond its tipping angle falls over
/// Each event is solved for, so the motion is exact to rounding. Throws Unsupported, with the body and the reason, if
/// no formula is known here: for a block that tips or lands turning, for a body that touches two things at once,
/// and so on.
/// Tests: tests/compare/closed_form/follows_test.cpp
std::vector<WorkedMotion> freeMotions(const Scene& scene);

}  // namespace plumb::compare
