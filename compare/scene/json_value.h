// SPDX-License-Identifier: MIT
// What does a scene look like as a JSON value, with its defaults or without?
#pragma once
#include <compare/scene/json.h>
#include <compare/scene/json_text.h>

namespace plumb::compare {

/// Throws std::invalid_argument as validate does.
Json jsonOf(const Scene& scene, Defaults defaults);
/// The same of a scene that is being checked.
Json uncheckedJsonOf(const Scene& scene, Defaults defaults);

/// The scene that the value describes. Throws std::invalid_argument, "bodies[2].angle: \"x\" is not a number", as
/// fromJson does, without a file and a line.
Scene sceneOf(const Json& value);

}  // namespace plumb::compare
