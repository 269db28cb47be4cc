// SPDX-License-Identifier: MIT
// What does the page know about the engines?
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include <compare/check/verdict.h>

namespace plumb::compare {

/// By name, in the order in which they are shown: label, role and look of the engines that were run, of those that labs
/// may run, and of variants with bullets.
nlohmann::json enginesData(const std::vector<SceneResult>& results);

/// What users of the scene's engines do outside of the engine; each note once.
nlohmann::json notesData(const SceneResult& result);

}  // namespace plumb::compare
