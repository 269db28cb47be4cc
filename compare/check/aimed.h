// SPDX-License-Identifier: MIT
// How must a scene's body be thrown to hit another one?
#pragma once
#include <optional>
#include <string>

#include <compare/scene/answer.h>

namespace plumb::compare {

/// By the kit's ballistics: of the body's speed at the start, its damping, the gravity on it, and the target's place
/// and constant velocity. Angles from +x, in degrees. None if no shot hits, or if the kit has no answer: for a target
/// that moves, and drag.
std::optional<double> aimed(const Scene& scene, const AimReading& wanted);

/// "deg", "s" or "m/s".
std::string unitOf(const AimReading& wanted);

}  // namespace plumb::compare
