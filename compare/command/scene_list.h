// SPDX-License-Identifier: MIT
// Which scenes are there, what are their questions, and what must hold in them?
#pragma once
#include <iosfwd>
#include <string>

#include <compare/command/scene_choice.h>
#include <compare/engine/engine.h>

namespace plumb::compare {

/// Those whose name, group or question contains the word, in small or capital letters; all for an empty word. The group
/// of a lab is "Labs". Throws std::invalid_argument if none contains it.
Choice containing(Choice all, const std::string& word);

/// Prints each group of scenes under its heading: the name, the question, the engines that can run it, and the checks
/// of each scene. The labs come last, under a heading of their own.
void listByGroup(const Choice& shown, const std::vector<Engine>& engines, std::ostream& out);

/// The check in words: "exact: plumb within 1e-09 m".
std::string checkText(const Scene& scene, const Check& check);

}  // namespace plumb::compare
