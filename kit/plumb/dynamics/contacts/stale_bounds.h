// SPDX-License-Identifier: MIT
// Which shapes has the last step moved out of the bounds that are stored in the space?
#pragma once
#include <atomic>
#include <span>
#include <vector>

#include <plumb/dynamics/bodies/body_store.h>
#include <plumb/shapes/aabb.h>
#include <plumb/space/detail/space.h>

namespace plumb {

/// A shape, and its present bounding box.
struct StaleBound {
    ProxyId proxy = 0;
    Aabb box;
};

/// Bounds are updated when a step begins, for the places that bodies reach if nothing pushes them. So until the next
/// step, a query of the space must also search this list. It is computed at the first query after a step; any number of
/// threads may call of() at the same time. Shapes that were moved or removed since then are still in the list: for them
/// the space is right.
class StaleBounds {
public:
    StaleBounds() = default;
    StaleBounds(const StaleBounds&) : known_(false) {}  // computed again
    StaleBounds& operator=(const StaleBounds&) {
        reset();
        return *this;
    }

    void reset() { known_ = false; }
    std::span<const StaleBound> of(const Space& space, const BodyStore& bodies) const;

private:
    mutable std::atomic<bool> known_ = true;
    mutable std::atomic_flag busy_;  ///< not a mutex: WebAssembly's C++ library may have none
    mutable std::vector<StaleBound> bounds_;
};

}  // namespace plumb
