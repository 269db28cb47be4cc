// SPDX-License-Identifier: MIT
// How much potential energy do bodies have in fields?
#pragma once
#include <plumb/dynamics/fields/field_store.h>

namespace plumb {

/// Does the field have a potential energy?
bool hasEnergy(const FieldDef& field);
/// The potential energy of all bodies in all fields that have one [J].
double fieldEnergyOf(const FieldStores& view);
/// The potential energy of one body if it were at there, with all other bodies where they are now [J].
double fieldEnergyOf(const FieldStores& view, BodyIndex body, const BodyMotion& there);

}  // namespace plumb
