// SPDX-License-Identifier: MIT
// Which shapes does a body have in the space, and what follows from them?
#pragma once
#include <span>

#include <plumb/dynamics/edit/shape_pieces.h>

namespace plumb {

/// The definition of a shape as it was given, rebuilt from its pieces. There must be at least one piece.
ShapeDef shapeOf(const WorldState& world, std::span<const ProxyId> pieces);
/// The mass of all shapes together, and of all shapes except the one with this number.
Mass massOfShapes(const WorldState& world, BodyIndex body);
Mass massOfShapesWithout(const WorldState& world, BodyIndex body, std::uint32_t number);

/// Adds a shape to a body at its present position, after the shapes with lower numbers.
void addShape(WorldState& world, BodyIndex body, const ShapeDef& def, std::uint32_t number);
/// Changes the material, filter or tag of a shape. Contacts that are still allowed stay, with their impulses.
void alterShape(WorldState& world, BodyIndex body, const ShapeDef& def, std::uint32_t number);
/// Wakes the shape's body and all bodies that touch the shape. To be called before the shape changes or is removed.
void wakeTouching(WorldState& world, BodyIndex body, std::uint32_t number);
/// Removes a shape from the space, with its contacts.
void removeShape(WorldState& world, BodyIndex body, std::uint32_t number);
void removeShapes(WorldState& world, BodyIndex body);

/// Removes all contacts of a body, and lets the space find the pairs of its shapes again.
void findPairsAgain(WorldState& world, BodyIndex body);
/// Marks the body's shapes in the space as fixed or not, by the type of the body.
void fixShapes(WorldState& world, BodyIndex body);
/// hideShapes disables a body and takes its shapes out of the space without removing them; showShapes reverses this.
void hideShapes(WorldState& world, BodyIndex body);
void showShapes(WorldState& world, BodyIndex body);

/// Gives a body another mass. Its position and the velocity of each of its points stay the same. Contacts keep their
/// impulses.
void giveMass(WorldState& world, BodyIndex body, const Mass& mass);
/// Sets the mass of a dynamic body from its shapes, unless it was given a mass.
void updateMassFromShapes(WorldState& world, BodyIndex body);

}  // namespace plumb
