// SPDX-License-Identifier: MIT
// What does a user of Box2D do from outside, where a scene has what Box2D has not?
#pragma once
#include <string>
#include <vector>

#include <compare/engine/engine.h>

namespace plumb::compare {

/// A sentence each, for the scene's page. stoppedMover: what takes the place of a mover that stops at what it meets.
std::vector<std::string> box2dNotes(const Scene& scene, const std::string& stoppedMover);

/// The card of the same engine with bullets, told from it by its stroke.
EngineCard asBullets(EngineCard card, std::vector<double> dash);

}  // namespace plumb::compare
