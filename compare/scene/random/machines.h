// SPDX-License-Identifier: MIT
// Which machines with joints are put into random scenes?
#pragma once
#include <compare/scene/random/draw.h>
#include <compare/scene/random/item.h>

namespace plumb::compare {

/// A doll of ten capsules on hinges with limits, at a random angle. Its parts pass through each other, as all bodies of
/// one negative group do.
Item drawDoll(Draw& draw, double density, int group);

/// This many planks between two points of the world; it hangs a little slack.
Item drawBridge(Draw& draw, int planks, double density, int group);

/// This many capsules in a row. It hangs on the world by one end, or falls.
Item drawRope(Draw& draw, int links, double density, int group);

/// A car with two wheels that have motors and are on springs.
Item drawCar(Draw& draw, double density);

/// Machines of at most this many bodies in total, at least 10; bridges come first.
std::vector<Item> drawMachines(Draw& draw, int bodies, double density);

}  // namespace plumb::compare
