// SPDX-License-Identifier: MIT
// Which shapes does a random body have?
#pragma once
#include <vector>

#include <compare/scene/random/item.h>
#include <compare/scene/random/style.h>

namespace plumb::compare {

/// One shape, or several of one material, within a circle of this radius around the body's origin. Each has at most
/// eight corners, none of which Box2D 3 welds, and is at least 2 cm thick. radius must be at least 10 cm.
std::vector<ShapeDef> drawShapes(Draw& draw, Form form, double radius, const Material& material);

/// A single body of the style.
Item drawBody(Draw& draw, const Style& style);

/// An L, a T, a cup, a cross, an arrow head or a dumb-bell.
std::vector<ShapeDef> drawCompound(Draw& draw, double radius, const Material& material);

}  // namespace plumb::compare
