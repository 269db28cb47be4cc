// SPDX-License-Identifier: MIT
// How does a scene's body look in Box2D 2.4? Only for sources that are compiled against Box2D 2.4's headers.
#pragma once
#include <box2d/box2d.h>

#include <deque>

#include <compare/engine/engine.h>

namespace plumb::compare {

b2Vec2 toBox2d24(const Vec2& v);

/// 0 where the scene bounces, else Box2D's default [m/s].
float restitutionThreshold24(const Scene& scene);

/// What Box2D 2.4's fixtures have no room for. A fixture's user data points to its own, which stays where it is; it is
/// null where there is nothing to say.
using Surfaces24 = std::deque<Material>;

/// Throws Unsupported, naming the body, when Box2D 2.4 cannot have it as it is.
b2Body* addBody24(b2World& world, const SceneBody& body, float restitutionThreshold, Surfaces24& surfaces);

/// Sets friction, restitution and belt speed of a contact that begins from its fixtures' surfaces.
void mixSurfaces24(b2Contact& contact);

BodyState stateOf24(const b2Body& body);

}  // namespace plumb::compare
