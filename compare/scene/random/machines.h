// SPDX-License-Identifier: MIT
// Which jointed things are put into random scenes?
#pragma once
#include <compare/scene/random/draw.h>
#include <compare/scene/random/item.h>

namespace plumb::compare {

/// A doll of ten capsules on hinges with limits, turned by chance; its parts pass each other, as those of one negative
/// group do.
Item drawDoll(Draw& draw, double density, int group);

/// So many planks between two points of the world, a little slack.
Item drawBridge(Draw& draw, int planks, double density, int group);

/// So many capsules in a row. It hangs on the world by one end, or falls.
Item drawRope(Draw& draw, int links, double density, int group);

/// Two wheels with motors on springs.
Item drawCar(Draw& draw, double density);

/// Machines of at most this many bodies together, at least 10; bridges first.
std::vector<Item> drawMachines(Draw& draw, int bodies, double density);

}  // namespace plumb::compare
