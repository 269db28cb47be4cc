// SPDX-License-Identifier: MIT
// Which scenes are there, what are their questions, and what must hold in them?
#pragma once
#include <iosfwd>
#include <span>

#include <compare/engine/engine.h>

namespace plumb::compare {

/// Prints the name, the question, the engines that can run it, and the checks of each scene.
void listScenes(std::span<const Scene> scenes, const std::vector<Engine>& engines, std::ostream& out);

/// The check in words: "exact: plumb within 1e-09 m".
std::string checkText(const Scene& scene, const Check& check);

}  // namespace plumb::compare
