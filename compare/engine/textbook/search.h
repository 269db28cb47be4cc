// SPDX-License-Identifier: MIT
// How is the moment of a collision found in one frame? To be looked at step by step.
#pragma once
#include <compare/engine/engine.h>

namespace plumb::compare {

/// Halves the frame (bisectCollision): tick 0 shows the frame's start, tick 1 its end, the ticks after them each probe,
/// and then the last probe. Where nothing overlaps at the end, nothing is found, and the end is shown on. The first
/// dynamic body moves straight on with its velocity; all others stand. Numbers: frame [s] and probes.
Engine bisectionEngine();

/// The swept test (firstTouch): tick 0 shows the frame's start, tick 1 the moment of impact, tick 2 the frame's end
/// after the law of impact. Where nothing is met, all show the way to the frame's end. Number: frame [s].
Engine sweptTestEngine();

}  // namespace plumb::compare
