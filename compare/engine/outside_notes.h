// SPDX-License-Identifier: MIT
// What must the user of an engine do from outside, if a scene has something that the engine lacks?
#pragma once
#include <string>
#include <vector>

#include <compare/engine/engine.h>

namespace plumb::compare {

/// One sentence for each thing, for the scene's page. The engine has no fields, no movers, and no world that wraps.
/// product: the engine's name for people; stoppedMover: what replaces a mover that stops at obstacles.
std::vector<std::string> outsideNotes(const Scene& scene, const std::string& product, const std::string& stoppedMover);

/// The card of the same engine with bullets. Its stroke is different.
EngineCard asBullets(EngineCard card, std::vector<double> dash);

}  // namespace plumb::compare
