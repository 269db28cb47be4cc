// SPDX-License-Identifier: MIT
// Which forces act on the bodies of a scene in Plumb?
#pragma once
#include <compare/engine/engine.h>
#include <compare/engine/plumb_world.h>

namespace plumb::compare {

/// At each contact point a normal and a friction force on each body that can move, and each joint's force.
std::vector<Push> plumbPushes(const PlumbWorld& made);

}  // namespace plumb::compare
