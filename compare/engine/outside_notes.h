// SPDX-License-Identifier: MIT
// What does the user of an engine do from outside, where a scene has what the engine has not?
#pragma once
#include <string>
#include <vector>

#include <compare/engine/engine.h>

namespace plumb::compare {

/// A sentence each, for the scene's page, of an engine without fields, movers and a world that wraps. product: as a
/// person calls it; stoppedMover: what takes the place of a mover that stops at what it meets.
std::vector<std::string> outsideNotes(const Scene& scene, const std::string& product, const std::string& stoppedMover);

/// The card of the same engine with bullets, told from it by its stroke.
EngineCard asBullets(EngineCard card, std::vector<double> dash);

}  // namespace plumb::compare
