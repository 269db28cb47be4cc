// SPDX-License-Identifier: MIT
// How does a contact get into a lane?
#pragma once
#include <plumb/dynamics/contacts/contact_graph.h>
#include <plumb/dynamics/contacts/lanes/fresh_lanes.h>
#include <plumb/space/space.h>

namespace plumb {

/// Puts what is known of a contact that has no slot into a lane.
void fillLane(ContactBatch& batch, ManifoldLanes& manifolds, std::size_t lane, const ContactRecord& contact,
              const BodyStore& bodies, const Space& space);
/// Puts a manifold where the kernels find it.
void setFresh(FreshLanes& fresh, std::size_t lane, const Manifold& manifold);

/// A body has become as heavy to turn as its joints need: so its contacts' lanes are to have it.
void renewGyration(ContactGraph& graph, const ContactStore& contacts, const BodyStore& bodies, const Space& space,
                   BodyIndex body);

}  // namespace plumb
