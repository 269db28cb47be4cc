// SPDX-License-Identifier: MIT
// Are two worlds in the same state, to the last bit?
#pragma once
#include <cstdint>

#include <plumb/dynamics/world.h>

namespace plumb {

/// FNV-1a over the bits of every body's id, position, angle and velocities, in the order of their slots.
std::uint64_t stateHash(const World& world);

}  // namespace plumb
