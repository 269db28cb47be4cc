// SPDX-License-Identifier: MIT
// How does a contact get into a lane?
#pragma once
#include <plumb/dynamics/detail/fresh_lanes.h>
#include <plumb/dynamics/detail/world_state.h>

namespace plumb {

/// Puts what is known of a contact that has no slot into a lane.
void fillLane(const WorldState& world, const ContactRecord& contact, ContactBatch& batch, ManifoldLanes& manifolds,
              std::size_t lane);
/// Puts a manifold where the kernels find it.
void setFresh(FreshLanes& fresh, std::size_t lane, const Manifold& manifold);

/// A body has become as heavy to turn as its joints need: so its contacts' lanes are to have it.
void renewRho(WorldState& world, BodyIndex body);

}  // namespace plumb
