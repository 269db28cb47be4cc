// SPDX-License-Identifier: MIT
// How is a scene run in Box2D 2.4?
#pragma once
#include <compare/engine/engine.h>

namespace plumb::compare {

/// Box2D 2.4 at its defaults: 8 velocity and 3 position iterations a step. The restitution threshold is 0 if a scene
/// bounces. A capsule is a box and two discs on one body, with the capsule's mass; a rounded polygon has a skin of its
/// radius, and its own mass. Unsupported: rolling resistance, polygons with more than 8 corners or with corners that
/// Box2D would weld, capsules not thicker than twice its skin, rods and segments of chains not longer than its slop,
/// filter categories and groups beyond 16 bits, numbers beyond single precision.
/// bullets: each body that moves at the start is flagged as a bullet, and the engine is called "box2d-2.4 bullets".
Engine box2d24Engine(bool bullets = false);

}  // namespace plumb::compare
