// SPDX-License-Identifier: MIT
// Which labs come with Plumb?
#pragma once
#include <optional>
#include <string>
#include <vector>

#include <compare/lab/lab.h>

namespace plumb::compare {

/// All labs, in the order in which they are listed and reported.
std::vector<Lab> builtinLabs();

/// The lab with this name; empty when there is none.
std::optional<Lab> findLab(const std::string& name);

}  // namespace plumb::compare
