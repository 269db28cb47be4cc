// SPDX-License-Identifier: MIT
// What does a page say of the runs of a scene?
#pragma once
#include <nlohmann/json_fwd.hpp>

#include <compare/check/verdict.h>

namespace plumb::compare {

/// What was changed, the verdict with its checks and limits, where engines part, notes, and for each engine its
/// settings, metrics and answer, or why it does not run the scene. What moves is left out.
nlohmann::json resultView(const SceneResult& result);

}  // namespace plumb::compare
