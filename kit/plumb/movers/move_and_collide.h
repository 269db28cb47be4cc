// SPDX-License-Identifier: MIT
// How far could a body move in a straight line, and what would stop it?
#pragma once
#include <optional>

#include <plumb/dynamics/world.h>

namespace plumb {

struct FreeMotion {
    Vec2 displacement{0, 0};                    ///< free part, up to a skin's distance from the obstacle [m]
    std::optional<CastHit> hit = std::nullopt;  ///< the obstacle; fraction is relative to the displacement asked for
};

/// Moves nothing. Moving bodies are hit where they are now; sensors are not hit, and one-way shapes from their open
/// side only. skin is the distance kept to obstacles, > 0 [m]. Throws std::invalid_argument for a stale id, a
/// displacement that is not finite, or a skin out of range.
/// Test: "a body is tested along 2,000 random ways, and goes as far as a cast says"
FreeMotion testMove(const World& world, BodyId body, const Vec2& displacement, double skin = 1e-3);

/// The same, and gives a kinematic body the velocity that takes it there with the next World::step(dt), dt > 0 [s].
/// Throws also when the body is not kinematic.
FreeMotion moveAndCollide(World& world, BodyId body, const Vec2& displacement, double dt, double skin = 1e-3);

}  // namespace plumb
