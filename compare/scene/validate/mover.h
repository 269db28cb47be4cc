// SPDX-License-Identifier: MIT
// Can a scene's mover be run?
#pragma once
#include <compare/scene/scene.h>

namespace plumb::compare {

/// Throws std::invalid_argument naming the field, the value and what was wanted. index is the mover's place in its
/// list.
void validateMover(const Scene& scene, std::size_t index);

}  // namespace plumb::compare
