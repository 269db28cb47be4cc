// SPDX-License-Identifier: MIT
// How does a body move through a step where there are fields?
//
// Before the step, all bodies that may feel one are flown through it by velocity Verlet at the sub-step, as if nothing
// touched them. What comes of it is put as a closed form that leads to the same place, so that all who ask where a body
// will be, and when it hits what, need to know nothing of fields; the velocity that this leaves over is added at the
// step's end. What bounces is flown anew from there. Where all that a body feels is steady, its closed form is exact.
// Source: Verlet, Phys. Rev. 159 (1967) 98, as kick, drift, kick.
// Tests: "two bodies go round each other as Kepler says", "an orbit keeps its energy for 100 rounds", "a puck between
// walls never speeds up", "linear drag and wind carry a ball as the closed form says"
#pragma once
#include <plumb/dynamics/fields/field_store.h>

namespace plumb {

/// In less than this no field could make a difference that a velocity holds, nor its law be told from rounding [s].
inline constexpr double shortestFelt = 1e-9;

/// A predicted flight, and what fields do on it.
struct FieldFlight {
    PredictedFlight flight;
    FieldAccount account;
};

/// At the start of a step of dt [s]: predicts the flights of all bodies that feel fields.
void predictFlights(FieldStore& fields, BodyStore& bodies, const Space& space, double dt);

/// How a body that feels fields moves on for a time, from where it is so long after the step's start [s].
FieldFlight flightFrom(FieldStore& fields, const BodyStore& bodies, const Space& space, const PredictedFlight& before,
                       const BodyMotion& from, double start, double time);

/// At the end of a step.
void clearFlights(FieldStore& fields, BodyStore& bodies);

}  // namespace plumb
