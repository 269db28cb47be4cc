// SPDX-License-Identifier: MIT
// Is it clear what appears when in a scene?
#pragma once
#include <compare/scene/name_index.h>
#include <compare/scene/scene.h>

namespace plumb::compare {

/// Bodies that appear later are kept simple: no probe, field, mover or closed form uses them. Joined bodies appear
/// together, or one of them is always there. Throws std::invalid_argument naming the field, the value and what was
/// wanted.
void validateArrivals(const Scene& scene, const NameIndex& bodies);

}  // namespace plumb::compare
