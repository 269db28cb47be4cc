// SPDX-License-Identifier: MIT
// What do fields do in a step?
//
// A world calls the code of fields through this table, which its first field sets. So the linker removes all code of
// fields from a program without fields. That is the table's only use: a page in a browser loads what is left.
#pragma once
#include <vector>

#include <plumb/dynamics/fields/field_flight.h>
#include <plumb/dynamics/fields/field_solving.h>
#include <plumb/dynamics/fields/field_store.h>

namespace plumb {

struct FieldPhases {
    /// Before a step: notes which bodies a field attracts, and returns those that may not sleep.
    std::vector<BodyIndex> (*gatherAttracted)(FieldStore& fields, FieldIndex field, const BodyStore& bodies,
                                              const Space& space);
    /// At the start of a step of dt [s].
    void (*predictFlights)(FieldStore& fields, BodyStore& bodies, const Space& space, double dt);
    /// Predicts a flight again from where a body is now (see field_flight.h).
    FieldFlight (*flightFrom)(FieldStore& fields, const BodyStore& bodies, const Space& space,
                              const PredictedFlight& before, const BodyMotion& from, double start, double time);
    /// In each half of a sub-step.
    void (FieldSolving::*kick)(const std::vector<BodyIndex>& solved);
    std::vector<BodyIndex> (*bodiesInfluencedBy)(const FieldStores& view, const FieldRecord& field);
    double (*energy)(const FieldStores& view);  ///< of all bodies [J]
    /// Of one body if it were at there [J].
    double (*energyOf)(const FieldStores& view, BodyIndex body, const BodyMotion& there);
};

extern const FieldPhases fieldPhases;

}  // namespace plumb
