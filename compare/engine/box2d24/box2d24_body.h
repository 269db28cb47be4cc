// SPDX-License-Identifier: MIT
// How is a scene's body made in Box2D 2.4? Only for sources that are compiled against Box2D 2.4's headers.
#pragma once
#include <box2d/box2d.h>

#include <deque>

#include <compare/engine/engine.h>

namespace plumb::compare {

b2Vec2 toBox2d24(const Vec2& v);

/// 0 if the scene bounces, else Box2D's default [m/s].
float restitutionThreshold24(const Scene& scene);

/// Materials with values that Box2D 2.4's fixtures cannot store. A fixture's user data points to its material, which
/// never moves in memory; it is null if the fixture needs none.
using Surfaces24 = std::deque<Material>;

/// Throws Unsupported, which names the body, if Box2D 2.4 cannot have the body as it is.
b2Body* addBody24(b2World& world, const SceneBody& body, float restitutionThreshold, Surfaces24& surfaces);

/// Sets friction, restitution and belt speed of a new contact, from the materials of its fixtures.
void mixSurfaces24(b2Contact& contact);

BodyState stateOf24(const b2Body& body);

}  // namespace plumb::compare
