// SPDX-License-Identifier: MIT
// Does a law keep a scene's energy?
#pragma once
#include <compare/scene/scene.h>

namespace plumb::compare {

/// True if nothing takes or gives energy: no damping, no motor, no field, no mover, no joint that stops hard or breaks,
/// no body that appears later, and no contacts except between elastic surfaces without friction.
bool keepsEnergy(const Scene& scene);

}  // namespace plumb::compare
