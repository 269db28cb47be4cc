// SPDX-License-Identifier: MIT
// How does a scene's body look in Box2D 3? Only for sources that are compiled against Box2D 3's headers.
#pragma once
#include <box2d/box2d.h>

#include <cstdint>

#include <compare/engine/engine.h>

namespace plumb::compare {

b2Vec2 toBox2d3(const Vec2& v);

/// senses: its shapes are seen by sensors. Throws Unsupported, naming the body, when Box2D 3 cannot have it as it is.
b2BodyId addBody3(b2WorldId world, const SceneBody& body, bool senses);

/// A pair's coefficients by the rules that its materials name, for worlds in which some material has its own.
float mixedFriction3(float a, std::uint64_t materialA, float b, std::uint64_t materialB);
float mixedRestitution3(float a, std::uint64_t materialA, float b, std::uint64_t materialB);

/// The angle is in (-pi, pi]: Box2D 3 keeps a rotation, and no count of turns.
BodyState stateOf3(b2BodyId body);

}  // namespace plumb::compare
