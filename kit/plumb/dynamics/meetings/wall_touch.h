// SPDX-License-Identifier: MIT
// Which contact and which events does a body's impact at a wall leave?
#pragma once
#include <plumb/dynamics/contacts/contact_graph.h>
#include <plumb/dynamics/meetings/wall_impact.h>

namespace plumb {

/// The stores that reporting reads and writes.
struct WallTouchStores {
    ContactGraph& graph;
    ContactStore& contacts;
    BodyStore& bodies;
    const Space& space;
    StepObserver* observer = nullptr;  ///< may be null
};

/// Adds the impulses of an impact, in a step of dt [s], to the contact of its two shapes, which is made if there is
/// none, and adds its events. Impacts faster than hitSpeed [m/s] are hits.
void reportWallImpact(const WallTouchStores& stores, const WallImpact& impact, double dt, double hitSpeed,
                      TouchEvents& touches);

}  // namespace plumb
