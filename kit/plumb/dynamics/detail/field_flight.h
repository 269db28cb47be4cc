// SPDX-License-Identifier: MIT
// How does a body fly through a step where there are fields?
//
// Before the step, all bodies are flown through it by velocity Verlet at the sub-step, as if nothing touched them. What
// comes of it is put as a steady acceleration that leads to the same place, so that all who ask a closed form where a
// body will be, and when it hits what, need to know nothing of fields; the velocity that this leaves over is added at
// the step's end.
// Source: Verlet, Phys. Rev. 159 (1967) 98, as kick, drift, kick.
// Tests: "two bodies go round each other as Kepler says", "an orbit keeps its energy for 100 rounds"
#pragma once
#include <plumb/dynamics/detail/world_state.h>

namespace plumb {

/// To be called at the start of a step.
void foretellFlights(WorldState& world, double dt);

/// A body that nothing touched, or that was flown by the impacts, has come where it was foretold.
void finishFlight(WorldState& world, BodyIndex body);

}  // namespace plumb
