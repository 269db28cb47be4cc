// SPDX-License-Identifier: MIT
// What does a schema say about a value whose type has no fields of its own?
#pragma once
#include <compare/scene/fields/field.h>
#include <compare/scene/json_text.h>
#include <plumb/math/member.h>

namespace plumb::compare {

/// A number within the allowed range; an infinite number is written as a word.
Json numberSchema(const Allowed& allowed);

/// [x, y], each within the allowed range.
Json vectorSchema(const Allowed& allowed);

/// A whole number with this number of bits.
Json signed32Schema();
Json unsigned64Schema();

/// Adds what every field has: its meaning and its unit.
void addMeaning(Json& schema, const Member& member);

}  // namespace plumb::compare
