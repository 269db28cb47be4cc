// SPDX-License-Identifier: MIT
// How is a contact written into a lane of a batch, and which load does a new one carry? The solver warm-starts with the
// impulses of the last step; new contacts have none.
#pragma once
#include <plumb/collide/lanes/pair_lanes.h>
#include <plumb/dynamics/bodies/body_store.h>
#include <plumb/dynamics/contacts/contact_batch.h>
#include <plumb/dynamics/contacts/contact_graph.h>
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

/// For each lane that touches and has no impulse yet, sets the impulses that balance the accelerations of its two
/// bodies during half a sub-step, as if the two were alone. Without this, the first sweeps of the solver turn a body
/// that only just begins to tip.
/// Test: "a block that begins to tip turns as its formula says from the first step on"
/// lanes: as in SolverSettings.
void guessImpulses(ContactBatch& batch, const BodyStore& bodies, int lanes);

}  // namespace plumb
