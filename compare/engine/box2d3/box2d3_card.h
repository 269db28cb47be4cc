// SPDX-License-Identifier: MIT
// What is known of Box2D 3, even if this build does not have it?
#pragma once
#include <compare/engine/engine.h>

namespace plumb::compare {

/// The card without a version.
EngineCard box2d3Card();

}  // namespace plumb::compare
