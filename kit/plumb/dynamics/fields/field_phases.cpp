// SPDX-License-Identifier: MIT
#include <plumb/dynamics/fields/field_phases.h>

#include <plumb/dynamics/fields/field_effects.h>
#include <plumb/dynamics/fields/field_scope.h>

namespace plumb {

const FieldPhases fieldPhases{
    gatherAttracted, predictFlights, flightFrom, &FieldSolving::kick, bodiesInfluencedBy, fieldEnergyOf, fieldEnergyOf,
};

}  // namespace plumb
