// SPDX-License-Identifier: MIT
// Which scenes measure speed?
#pragma once
#include <functional>
#include <string>
#include <vector>

#include <compare/scene/scene.h>

namespace plumb::compare {

/// A scene that needs much memory: it is built only when it is run.
struct BenchScene {
    std::string name{};
    std::string group{};   ///< a name for several scenes: "six", "scaling", "crowds", "jointed", "random", or none
    std::string family{};  ///< a name for scenes that differ only in size, or none
    std::function<Scene()> build{};  ///< builds the scene; its name is name
};

/// All of them, in the order in which they are listed.
const std::vector<BenchScene>& benchScenes();

/// The scenes that a name stands for: one scene, or a group, "six", "scaling", "crowds" or "jointed". Empty when there
/// is none of that name.
std::vector<BenchScene> findBenchScenes(const std::string& name);

}  // namespace plumb::compare
