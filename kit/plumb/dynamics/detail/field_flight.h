// SPDX-License-Identifier: MIT
// How does a body fly through a step where there are fields?
//
// Before the step, all bodies that may feel one are flown through it by velocity Verlet at the sub-step, as if nothing
// touched them. What comes of it is put as a closed form that leads to the same place, so that all who ask where a body
// will be, and when it hits what, need to know nothing of fields; the velocity that this leaves over is added at the
// step's end. What bounces is flown anew from there. Where all that a body feels is steady, its closed form is exact.
// Source: Verlet, Phys. Rev. 159 (1967) 98, as kick, drift, kick.
// Tests: "two bodies go round each other as Kepler says", "an orbit keeps its energy for 100 rounds", "a puck between
// walls never speeds up", "linear drag and wind carry a ball as the closed form says"
#pragma once
#include <plumb/dynamics/detail/world_state.h>

namespace plumb {

/// To be called at the start of a step.
void foretellFlights(WorldState& world, double dt);

/// How a body that feels fields flies on for a time, from where it is so long after the step's start [s].
FieldFlight flightFrom(WorldState& world, const FieldFlight& before, const BodyMotion& from, double start, double time);

/// A body that nothing has touched has come where it was foretold.
void finishFlight(WorldState& world, BodyIndex body);

/// At the end of a step.
void forgetFlights(WorldState& world);

}  // namespace plumb
