// SPDX-License-Identifier: MIT
// Does a law keep a scene's energy?
#pragma once
#include <compare/scene/scene.h>

namespace plumb::compare {

/// Nothing takes energy or gives it: no damping, no motor, no field, no mover, no joint that stops hard or breaks, no
/// body that comes later, and no touch but of surfaces that are elastic and without friction.
bool keepsEnergy(const Scene& scene);

}  // namespace plumb::compare
