// SPDX-License-Identifier: MIT
// What does a schema say of a value of a type that has no fields of its own?
#pragma once
#include <compare/scene/fields/field.h>
#include <compare/scene/json_text.h>
#include <plumb/math/member.h>

namespace plumb::compare {

/// A number within what is allowed; an infinite one stands as a word.
Json numberSchema(const Allowed& allowed);

/// [x, y], each within what is allowed.
Json vectorSchema(const Allowed& allowed);

/// A whole number of so many bits.
Json signed32Schema();
Json unsigned64Schema();

/// What is said of every field: its meaning and its unit.
void addMeaning(Json& schema, const Member& member);

}  // namespace plumb::compare
