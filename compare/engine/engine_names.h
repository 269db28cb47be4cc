// SPDX-License-Identifier: MIT
// Are the engines that a scene names known?
#pragma once
#include <compare/scene/scene.h>

namespace plumb::compare {

/// Throws std::invalid_argument for an unknown engine; it names the field, the name, and the nearest known name. An
/// engine is known even if this build does not have it.
void validateEngineNames(const Scene& scene);

}  // namespace plumb::compare
