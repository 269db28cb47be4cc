// SPDX-License-Identifier: MIT
// Which scenes and labs are meant by names and files?
#pragma once
#include <span>
#include <string>
#include <vector>

#include <compare/lab/lab.h>
#include <compare/scene/bench.h>
#include <compare/scene/scene.h>

namespace plumb::compare {

/// The scenes in the order given; all built-in ones when nothing is given. What ends in ".json" is read as a file; what
/// is no name of a built-in scene may be one of a scene that measures speed. "random:SEED" is the random scene of a
/// seed, and "random:A..B" those of seeds A to B. Throws std::invalid_argument for a name that is not known, naming the
/// nearest, for two scenes of the same name, and as readScene does.
std::vector<Scene> chooseScenes(std::span<const std::string> given);

struct Choice {
    std::vector<Scene> scenes;
    std::vector<Lab> labs;
};

/// As chooseScenes, and labs by name; all of both when nothing is given.
Choice chooseScenesAndLabs(std::span<const std::string> given);

/// The scenes to be measured: scenes and groups by name, or else as chooseScenes; the group "six" when nothing is
/// given. Throws as chooseScenes does.
std::vector<BenchScene> chooseBenchScenes(std::span<const std::string> given);

}  // namespace plumb::compare
