// SPDX-License-Identifier: MIT
// How is a scene run in Box2D 3?
#pragma once
#include <compare/engine/engine.h>

namespace plumb::compare {

/// Box2D 3.2 or later at its defaults, among them 4 sub-steps a step. The restitution threshold is 0 if a scene
/// bounces. Unsupported: polygons with more than 8 corners or with corners that Box2D would weld, rings with fewer than
/// 4 points, capsules, segments and rods shorter than its slop, numbers beyond single precision. bullets: each body
/// that moves at the start is flagged as a bullet, and the engine is called "box2d-3 bullets". If Plumb was built
/// without Box2D 3, the engine cannot build any scene.
Engine box2d3Engine(bool bullets = false, int subSteps = 4);

}  // namespace plumb::compare
