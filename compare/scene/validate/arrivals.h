// SPDX-License-Identifier: MIT
// Is it clear what comes when in a scene?
#pragma once
#include <compare/scene/name_index.h>
#include <compare/scene/scene.h>

namespace plumb::compare {

/// What comes later is simple: no probe, field, mover or closed form knows it, and what is joined comes together, or to
/// what is always there. Throws std::invalid_argument naming the field, the value and what was wanted.
void validateArrivals(const Scene& scene, const NameIndex& bodies);

}  // namespace plumb::compare
