// SPDX-License-Identifier: MIT
// Is a part of a scene valid, together with the others?
#pragma once
#include <cstddef>

#include <compare/scene/name_index.h>
#include <compare/scene/scene.h>

namespace plumb::compare {

/// Bodies that appear later are kept simple: no probe, field, mover or closed form uses them. Joined bodies appear
/// together, or one of them is always there. Throws std::invalid_argument naming the field, the value and what was
/// wanted.
void validateArrivals(const Scene& scene, const NameIndex& bodies);

/// Throws std::invalid_argument as validate(scene) does, for the joint at this place. bodies are the scene's.
void validateJoint(const Scene& scene, std::size_t joint, const NameIndex& bodies);

/// Throws std::invalid_argument naming the field, the value and what was wanted. index is the mover's place in its
/// list.
void validateMover(const Scene& scene, std::size_t index);

}  // namespace plumb::compare
