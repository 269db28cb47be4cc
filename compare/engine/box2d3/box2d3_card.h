// SPDX-License-Identifier: MIT
// What is known of Box2D 3, in this build or not?
#pragma once
#include <compare/engine/engine.h>

namespace plumb::compare {

/// Without a version.
EngineCard box2d3Card();

}  // namespace plumb::compare
