// SPDX-License-Identifier: MIT
// Which part of an outline is under water, when all of it is known to be sound?
#pragma once
#include <plumb/forces/buoyancy.h>

namespace plumb {

/// As submergedPart, unchecked.
Submerged submergedPartOf(std::span<const Vec2> corners, double radius, const Fluid& fluid);

}  // namespace plumb
