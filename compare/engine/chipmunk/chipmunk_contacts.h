// SPDX-License-Identifier: MIT
// What has to be told to Chipmunk of each contact, and what is counted there? Only for sources that are compiled
// against Chipmunk's headers.
#pragma once
#include <chipmunk/chipmunk.h>

#include <cstddef>
#include <vector>

#include <compare/engine/engine.h>

namespace plumb::compare {

/// A body with sensors, and how often something came into them.
struct ChipmunkGate {
    std::size_t body = 0;  ///< its place in the scene
    int count = 0;
};

/// Stays where it is while the space is there.
struct ChipmunkContacts {
    bool filters = false;  ///< it has to decide what may touch: Chipmunk's own filters are off
    std::vector<ChipmunkGate> gates{};
};

/// Is Chipmunk's own rule, with the coefficients that its shapes get here, not what the scene says?
bool needsChipmunkMixing(const Scene& scene);

/// Asks to be called only where there is something to say: told of every contact in every step, a handler costs time.
void listenToChipmunk(cpSpace& space, const Scene& scene, ChipmunkContacts& contacts);

/// How hard one body presses on another, from the impulses of the last step [N s].
double pressedInChipmunk(cpBody* a, const cpBody* b);

}  // namespace plumb::compare
