// SPDX-License-Identifier: MIT
// How far does Box2D 3's own character mover take a capsule? Only for sources compiled against Box2D 3's headers.
#pragma once
#include <box2d/box2d.h>

#include <compare/scene/scene.h>

namespace plumb::compare {

/// Excludes the body's capsule from what characters collide with, because it would collide with itself.
void makeCharacter3(b2BodyId body);

/// The velocity that moves the body in a step of dt [s] as far as the mover allows, if it wants to go at the wanted
/// velocity [m/s]. It works like the library's sample of a character: gather planes, solve them, cast along the
/// solution, and repeat until nothing is left, at most five times.
Vec2 characterVelocity3(b2WorldId world, b2BodyId body, const Vec2& wanted, double dt);

}  // namespace plumb::compare
