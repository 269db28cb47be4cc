// SPDX-License-Identifier: MIT
// What does a scene give to one engine alone?
#pragma once
#include <compare/engine/engine.h>

namespace plumb::compare {

/// The scene as an engine is to be given it: with the fields that it sets for this engine, but for the engine's own
/// numbers. Throws std::invalid_argument, "engines.box2d-3.bodies.bal.friction: ...", for a field that there is not, or
/// that has to be the same for all: what is not of gravity, sleeping, bodies, joints, fields and movers.
Scene sceneFor(const std::string& engine, const Scene& scene);

/// What the scene says of one of the engine's own numbers, or its default. Throws std::invalid_argument for a value
/// that is not allowed.
double numberFor(const std::string& engine, const EngineNumber& number, const Scene& scene);

/// What a list of settings says of it: "bodies.ball.friction", "0.3, for this engine alone".
std::vector<Setting> settingsFor(const std::string& engine, const Scene& scene);

/// The engine that takes what scenes set for it, refuses what it does not know, and lists it among its settings.
Engine takingSettings(Engine engine);

}  // namespace plumb::compare
