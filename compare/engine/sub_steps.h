// SPDX-License-Identifier: MIT
// What if an engine solved a step in one part?
#pragma once
#include <compare/engine/engine.h>

namespace plumb::compare {

/// Plumb, or Box2D 3, with one sub-step a step. Another engine is returned as it is: it has no sub-steps.
Engine withOneSubStep(const Engine& engine);

}  // namespace plumb::compare
