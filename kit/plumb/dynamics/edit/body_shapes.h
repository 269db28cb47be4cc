// SPDX-License-Identifier: MIT
// Which shapes does a body have in the space, and what follows from them?
#pragma once
#include <span>

#include <plumb/dynamics/edit/shape_pieces.h>

namespace plumb {

/// What was given, rebuilt from its pieces, of which there is one at least.
ShapeDef shapeOf(const WorldState& world, std::span<const ProxyId> pieces);
/// What all shapes together weigh, and, of those, all but one number's.
Mass massOfShapes(const WorldState& world, BodyIndex body);
Mass massOfShapesWithout(const WorldState& world, BodyIndex body, std::uint32_t number);

/// Puts a shape where the body is now, behind those of lower numbers.
void addShape(WorldState& world, BodyIndex body, const ShapeDef& def, std::uint32_t number);
/// Gives a shape another material, filter or tag, and keeps contacts and their impulses where they may stay.
void alterShape(WorldState& world, BodyIndex body, const ShapeDef& def, std::uint32_t number);
/// Wakes what touches a shape, before it changes or goes, and its body.
void wakeTouching(WorldState& world, BodyIndex body, std::uint32_t number);
/// Takes a shape out of the space, and its contacts with it.
void removeShape(WorldState& world, BodyIndex body, std::uint32_t number);
void removeShapes(WorldState& world, BodyIndex body);

/// Takes all contacts of a body out of the world, and lets the space find all that its shapes meet anew.
void meetAnew(WorldState& world, BodyIndex body);
/// Its shapes are fixed or not, as its type says.
void fixShapes(WorldState& world, BodyIndex body);
/// Takes its shapes out of the space without forgetting them, and back.
void hideShapes(WorldState& world, BodyIndex body);
void showShapes(WorldState& world, BodyIndex body);

/// Gives a body another mass; it stays where it is and moves on as it did. Contacts keep their impulses.
void giveMass(WorldState& world, BodyIndex body, const Mass& mass);
/// What it weighs by its shapes, unless it was given a mass. Nothing for one that is not dynamic.
void followShapes(WorldState& world, BodyIndex body);

}  // namespace plumb
