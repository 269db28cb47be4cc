// SPDX-License-Identifier: MIT
// Is a scene's mover one that can be run?
#pragma once
#include <compare/scene/scene.h>

namespace plumb::compare {

/// Throws std::invalid_argument naming the field, the value and what was wanted; index is the mover's place.
void validateMover(const Scene& scene, std::size_t index);

}  // namespace plumb::compare
