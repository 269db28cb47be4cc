// SPDX-License-Identifier: MIT
// How far could a body go straight on, and what would stop it?
#pragma once
#include <optional>

#include <plumb/dynamics/world.h>

namespace plumb {

struct FreeMotion {
    Vec2 displacement{0, 0};                    ///< as far as the way is free, a skin short of what stops it [m]
    std::optional<CastHit> hit = std::nullopt;  ///< what does; fraction is of the way asked for
};

/// Moves nothing. What moves is met where it is now; sensors are not met, and one-way shapes from their open side only.
/// skin is kept to what is met, > 0 [m]. Throws std::invalid_argument for a stale id, a displacement that is not
/// finite, or a skin out of range. Test: "a body is tested along 2,000 random ways, and goes as far as a cast says"
FreeMotion testMove(const World& world, BodyId body, const Vec2& displacement, double skin = 1e-3);

/// The same, and gives a kinematic body the velocity that takes it there with the next World::step(dt), dt > 0 [s].
/// Throws also when the body is not kinematic.
FreeMotion moveAndCollide(World& world, BodyId body, const Vec2& displacement, double dt, double skin = 1e-3);

}  // namespace plumb
