// SPDX-License-Identifier: MIT
// What must be set for each contact in Chipmunk, and what is counted there? Only for sources that are compiled against
// Chipmunk's headers.
#pragma once
#include <chipmunk/chipmunk.h>

#include <cstddef>
#include <vector>

#include <compare/engine/engine.h>

namespace plumb::compare {

/// A body with sensors, and how often something has entered them.
struct ChipmunkGate {
    std::size_t body = 0;  ///< its index in the scene
    int count = 0;
};

/// It must not move in memory while the space exists.
struct ChipmunkContacts {
    bool filters = false;  ///< the handler decides which shapes may touch, because Chipmunk's own filters are off
    std::vector<ChipmunkGate> gates{};
};

/// Does Chipmunk's own rule, with the coefficients that its shapes get here, differ from the rules of the scene?
bool needsChipmunkMixing(const Scene& scene);

/// Sets a handler only if it is needed: it is called for every contact in every step, which costs time.
void listenToChipmunk(cpSpace& space, const Scene& scene, ChipmunkContacts& contacts);

/// How hard one body presses on another, from the impulses of the last step [N s].
double pressedInChipmunk(cpBody* a, const cpBody* b);

}  // namespace plumb::compare
