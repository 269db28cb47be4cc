// SPDX-License-Identifier: MIT
// How is a scene run in Box2D 2.4?
#pragma once
#include <compare/engine/engine.h>

namespace plumb::compare {

/// Box2D 2.4 at its defaults: 8 velocity and 3 position iterations a step. Restitution threshold 0 where a scene
/// bounces. Unsupported: filter categories beyond 16 bits, polygons with corners that Box2D would weld, rods shorter
/// than its slop, numbers beyond single precision.
Engine box2d24Engine();

}  // namespace plumb::compare
