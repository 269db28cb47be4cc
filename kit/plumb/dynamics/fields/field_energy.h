// SPDX-License-Identifier: MIT
// How much potential energy do bodies have in fields?
#pragma once
#include <plumb/dynamics/fields/field_store.h>

namespace plumb {

/// Does what it does have a potential energy?
bool hasEnergy(const FieldDef& field);
/// Of all bodies in all fields that have one [J].
double fieldEnergyOf(const FieldView& view);
/// Of one body, if it were there, and all others where they are.
double fieldEnergyOf(const FieldView& view, BodyIndex body, const BodyMotion& there);

}  // namespace plumb
