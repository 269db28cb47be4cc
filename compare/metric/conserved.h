// SPDX-License-Identifier: MIT
// What do laws keep the same in a scene, so that its drift is an error?
#pragma once
#include <string>
#include <vector>

#include <compare/scene/scene.h>

namespace plumb::compare {

/// Which of the metrics momentum_drift and angular_momentum_drift say something about an engine: both if only the
/// scene's dynamic bodies act on each other; only the first if the scene continues at its opposite side, where a jump
/// across the edge changes the angular momentum; and each that a check of the scene asks for. Something else acts where
/// there is gravity, damping, a mover, or a field other than the bodies' own gravity; where a body that is not dynamic
/// may touch one or is jointed to one; where a body cannot move freely or a joint holds it to the world; and where one
/// appears or disappears.
std::vector<std::string> conservedMomenta(const Scene& scene);

/// True if nothing takes or gives energy: no damping, no motor, no field, no mover, no joint that stops hard or breaks,
/// no body that appears later, and no contacts except between elastic surfaces without friction.
bool keepsEnergy(const Scene& scene);

}  // namespace plumb::compare
