// SPDX-License-Identifier: MIT
// How is a contact written into a lane of a batch?
#pragma once
#include <plumb/dynamics/contacts/contact_graph.h>
#include <plumb/dynamics/contacts/lanes/fresh_lanes.h>
#include <plumb/space/detail/space.h>

namespace plumb {

/// Writes the data of a contact that has no slot into a lane.
void fillLane(ContactBatch& batch, ManifoldLanes& manifolds, std::size_t lane, const ContactRecord& contact,
              const BodyStore& bodies, const Space& space);
/// Writes a manifold into a lane of fresh manifolds.
void setFresh(FreshLanes& fresh, std::size_t lane, const Manifold& manifold);
/// Reads it, without its features.
Manifold manifoldAt(const FreshLanes& fresh, std::size_t lane);

/// The smaller separation of the points in a lane that has some [m].
float nearestOf(const FreshLanes& fresh, std::size_t lane);

/// Lets the solver see a body with another mass, and its contacts with it. inverseGyration: the inverse of its radius
/// of gyration [1/m]; it stays 0 for a body that cannot turn.
void setSolverMass(ContactGraph& graph, const ContactStore& contacts, BodyStore& bodies, BodyIndex body,
                   float inverseMass, float inverseGyration);

}  // namespace plumb
