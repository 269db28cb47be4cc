// SPDX-License-Identifier: MIT
// Which scenes come with Plumb?
#pragma once
#include <optional>
#include <string>
#include <vector>

#include <compare/scene/scene.h>

namespace plumb::compare {

/// All of them, in the order in which they are listed and reported.
std::vector<Scene> builtinScenes();

/// The one of this name; empty when there is none.
std::optional<Scene> findScene(const std::string& name);

}  // namespace plumb::compare
