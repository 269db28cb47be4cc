// SPDX-License-Identifier: MIT
// How is a scene's body made in Box2D 3? Only for sources that are compiled against Box2D 3's headers.
#pragma once
#include <box2d/box2d.h>

#include <cstdint>

#include <compare/engine/engine.h>

namespace plumb::compare {

b2Vec2 toBox2d3(const Vec2& v);

/// senses: sensors see the body's shapes. Throws Unsupported, which names the body, if Box2D 3 cannot have it as it is.
b2BodyId addBody3(b2WorldId world, const SceneBody& body, bool senses);

/// A pair's coefficients by the rules of its two materials. Only for worlds in which a material has other rules than
/// Box2D's.
float mixedFriction3(float a, std::uint64_t materialA, float b, std::uint64_t materialB);
float mixedRestitution3(float a, std::uint64_t materialA, float b, std::uint64_t materialB);

/// The angle is in (-pi, pi]: Box2D 3 stores a rotation, but does not count turns.
BodyState stateOf3(b2BodyId body);

}  // namespace plumb::compare
