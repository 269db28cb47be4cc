// SPDX-License-Identifier: MIT
// Can a scene have this joint?
#pragma once
#include <cstddef>

#include <compare/scene/name_index.h>
#include <compare/scene/scene.h>

namespace plumb::compare {

/// Throws std::invalid_argument as validate(scene) does, for the joint at this place. bodies are the scene's.
void validateJoint(const Scene& scene, std::size_t joint, const NameIndex& bodies);

}  // namespace plumb::compare
