// SPDX-License-Identifier: MIT
// Which shapes does a random body have?
#pragma once
#include <vector>

#include <compare/scene/random/item.h>
#include <compare/scene/random/style.h>

namespace plumb::compare {

/// One shape, or several of one material, within a circle of this radius around the body's origin. Each has at most
/// eight corners, of which Box2D 3 welds none, and is at least 2 cm thick: radius is at least 10 cm.
std::vector<ShapeDef> drawShapes(Draw& draw, Form form, double radius, const Material& material);

/// A body of the style, alone.
Item drawBody(Draw& draw, const Style& style);

/// An L, a T, a cup, a cross, an arrow head or a dumb-bell.
std::vector<ShapeDef> drawCompound(Draw& draw, double radius, const Material& material);

}  // namespace plumb::compare
