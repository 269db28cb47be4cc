// SPDX-License-Identifier: MIT
// Are the engines that a scene names known?
#pragma once
#include <compare/scene/scene.h>

namespace plumb::compare {

/// Throws std::invalid_argument naming the field, the name, and the one nearest to it. An engine is known whether this
/// build has it or not.
void validateEngineNames(const Scene& scene);

}  // namespace plumb::compare
