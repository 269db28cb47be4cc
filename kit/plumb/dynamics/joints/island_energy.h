// SPDX-License-Identifier: MIT
// How much energy do joints give to their island, and how is it taken back?
//
// A row that holds does the work L (v + v') / 2 with its impulse L, at its speeds v before and v' after it. A joint may
// do none. In a sub-step it does some, because bodies move straight on where they should turn: what it gives before the
// move it takes after it, but for a rest that may have either sign. Where links turn far in a sub-step, the rest is
// large: a light cart under a pendulum gained ten times the energy of the fall. So a loss is noted, and may come back;
// what exceeds it is taken from the velocities, except from those of the island as a whole.
#pragma once
#include <plumb/dynamics/joints/island_numbers.h>

namespace plumb {

/// What forces do at these velocities, by their impulses in half a sub-step [J].
double fallOf(const IslandNumbers& numbers, std::size_t lane, int velocity);
/// The energy of an island, but for that of its motion as a whole [J].
double energyOf(const IslandNumbers& numbers, const BodyStore& bodies, std::size_t lane);
/// Takes so much of it, with the masses that are solved for. Returns how much there was to take.
double takeEnergy(const IslandNumbers& numbers, const BodyStore& bodies, std::size_t lane, double energy);

}  // namespace plumb
