// SPDX-License-Identifier: MIT
// How is a scene run in Box2D 3?
#pragma once
#include <compare/engine/engine.h>

namespace plumb::compare {

/// Box2D 3.2 or later at its defaults, among them 4 sub-steps a step. Restitution threshold 0 where a scene bounces.
/// Unsupported: polygons of more than 8 corners or with corners that Box2D would weld, rings of fewer than 4 points,
/// capsules, segments and rods shorter than its slop, numbers beyond single precision. bullets: what moves at the start
/// is flagged as one, and the engine is called "box2d-3 bullets". Where Plumb was built without
/// Box2D 3, it cannot build anything.
Engine box2d3Engine(bool bullets = false, int subSteps = 4);

}  // namespace plumb::compare
