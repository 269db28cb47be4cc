// SPDX-License-Identifier: MIT
// How is a scene run in Chipmunk?
#pragma once
#include <compare/engine/engine.h>

namespace plumb::compare {

/// Chipmunk 7 at its defaults: 10 iterations a step, and joints that remove a tenth of their error in a sixtieth of a
/// second. Its slop is made for pixels, so Box2D's slop is used. A capsule is a segment with a radius, and a chain is a
/// list of segments. A wheel or a slide is a groove with springs and motors. Unsupported: rolling resistance, one-way
/// shapes, locks along an axis, pulleys, targets, motors along a line, welds with a soft anchor, and gears except
/// between two hinges on static bases.
Engine chipmunkEngine();

}  // namespace plumb::compare
