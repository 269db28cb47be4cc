// SPDX-License-Identifier: MIT
// What does the page know of the engines?
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include <compare/check/verdict.h>

namespace plumb::compare {

/// By name, in the order in which they are shown: label, role and look of those that were run, of those that labs may
/// run, and of variants with bullets.
nlohmann::json enginesData(const std::vector<SceneResult>& results);

/// Once each, what the users of the scene's engines do from outside.
nlohmann::json notesData(const SceneResult& result);

}  // namespace plumb::compare
