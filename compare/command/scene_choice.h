// SPDX-License-Identifier: MIT
// Which scenes are meant by names and files?
#pragma once
#include <span>
#include <string>
#include <vector>

#include <compare/scene/scene.h>

namespace plumb::compare {

/// The scenes in the order given; all built-in ones when nothing is given. What ends in ".json" is read as a file.
/// Throws std::invalid_argument for a name that is not known, naming the nearest, for two scenes of the same name, and
/// as readScene does.
std::vector<Scene> chooseScenes(std::span<const std::string> given);

}  // namespace plumb::compare
