// SPDX-License-Identifier: MIT
// How is a scene run in Chipmunk?
#pragma once
#include <compare/engine/engine.h>

namespace plumb::compare {

/// Chipmunk 7 at its defaults: 10 iterations a step, and joints that take off a tenth of their error in a sixtieth of a
/// second. Its slop is made for pixels, so it gets Box2D's. A capsule is a segment with a radius, a chain so many
/// segments, a wheel or slide a groove with springs and motors beside it. Unsupported: rolling resistance, one-way
/// shapes, locks along an axis, pulleys, targets, motors along a line, welds whose anchor gives, gears other than of
/// two hinges on static bases.
Engine chipmunkEngine();

}  // namespace plumb::compare
