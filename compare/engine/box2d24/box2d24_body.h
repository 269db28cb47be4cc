// SPDX-License-Identifier: MIT
// How does a scene's body look in Box2D 2.4? Only for sources that are compiled against Box2D 2.4's headers.
#pragma once
#include <box2d/box2d.h>

#include <compare/engine/engine.h>

namespace plumb::compare {

b2Vec2 toBox2d24(const Vec2& v);

/// 0 where the scene bounces, else Box2D's default [m/s].
float restitutionThreshold24(const Scene& scene);

/// Throws Unsupported, naming the body, when Box2D 2.4 cannot have it as it is.
b2Body* addBody24(b2World& world, const SceneBody& body, float restitutionThreshold);

BodyState stateOf24(const b2Body& body);

}  // namespace plumb::compare
