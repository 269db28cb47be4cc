// SPDX-License-Identifier: MIT
// What does a scene set for one engine only?
#pragma once
#include <compare/engine/engine.h>

namespace plumb::compare {

/// The scene that an engine gets: with the fields that the scene sets for this engine, except the engine's own numbers.
/// Throws std::invalid_argument, "engines.box2d-3.bodies.bal.friction: ...", for a field that does not exist, or that
/// must be the same for all engines. Only gravity, sleeping, bodies, joints, fields and movers may differ.
Scene sceneFor(const std::string& engine, const Scene& scene);

/// The value that the scene sets for one of the engine's own numbers, or the default. Throws std::invalid_argument for
/// a value that is not allowed.
double numberFor(const std::string& engine, const EngineNumber& number, const Scene& scene);

/// The fields that the scene sets for the engine, as settings: "bodies.ball.friction", "0.3, for this engine alone".
std::vector<Setting> settingsFor(const std::string& engine, const Scene& scene);

/// The same engine, but it also applies the fields that scenes set for it, refuses unknown ones, and lists them in its
/// settings.
Engine takingSettings(Engine engine);

}  // namespace plumb::compare
