// SPDX-License-Identifier: MIT
// Are the numbers of a definition within what its description allows?
#pragma once
#include <cstddef>

namespace plumb {

struct Mass;
struct TileMapDef;

// Each throws std::invalid_argument with the member's name, its value and what is wanted.

void requireMass(const Mass& mass, const char* field, std::size_t index);
void requireNumbers(const TileMapDef& def);

}  // namespace plumb
