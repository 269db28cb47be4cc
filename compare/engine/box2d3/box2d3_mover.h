// SPDX-License-Identifier: MIT
// How far does Box2D 3's own character mover take a capsule? Only for sources compiled against Box2D 3's headers.
#pragma once
#include <box2d/box2d.h>

#include <compare/scene/scene.h>

namespace plumb::compare {

/// Takes the body's capsule out of what characters collide with: it would meet itself.
void makeCharacter3(b2BodyId body);

/// The velocity that takes the body in a step of dt [s] as far as the mover lets it on its way at that wanted one
/// [m/s]. As the library's sample of a character does it: gather planes, solve them, cast along the answer, again until
/// nothing is left; at most five times.
Vec2 characterVelocity3(b2WorldId world, b2BodyId body, const Vec2& wanted, double dt);

}  // namespace plumb::compare
