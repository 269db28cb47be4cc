// SPDX-License-Identifier: MIT
// Which scenes and labs belong to the given names and files?
#pragma once
#include <span>
#include <string>
#include <vector>

#include <compare/lab/lab.h>
#include <compare/scene/bench.h>
#include <compare/scene/scene.h>

namespace plumb::compare {

/// The scenes in the order given; all built-in scenes if nothing is given. A text that ends in ".json" is read as a
/// file. Names of built-in scenes are tried first, then names of scenes that measure speed. "random:SEED" is the random
/// scene of a seed, and "random:A..B" those of seeds A to B. Throws std::invalid_argument for an unknown name (and
/// names the nearest known one), for two scenes with the same name, and in the cases in which readScene does.
std::vector<Scene> chooseScenes(std::span<const std::string> given);

struct Choice {
    std::vector<Scene> scenes;
    std::vector<Lab> labs;
};

/// Like chooseScenes, but also finds labs by name; all scenes and labs if nothing is given.
Choice chooseScenesAndLabs(std::span<const std::string> given);

/// The scenes to be measured. Names of groups and of scenes that measure speed are tried first; other names are read as
/// by chooseScenes. The group "six" if nothing is given. Throws as chooseScenes does.
std::vector<BenchScene> chooseBenchScenes(std::span<const std::string> given);

}  // namespace plumb::compare
