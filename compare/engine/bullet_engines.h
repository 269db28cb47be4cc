// SPDX-License-Identifier: MIT
// What if bodies were flagged as bullets?
#pragma once
#include <optional>

#include <compare/engine/engine.h>

namespace plumb::compare {

/// The engine with that flag on every body that moves at the start, called "box2d-3 bullets"; empty for engines that
/// have no such flag: Plumb and the closed form.
std::optional<Engine> withBullets(const Engine& engine);

}  // namespace plumb::compare
