// SPDX-License-Identifier: MIT
// Which shapes has the last step moved out of the bounds that the space has for them?
#pragma once
#include <atomic>
#include <mutex>
#include <span>
#include <vector>

#include <plumb/dynamics/bodies/body_store.h>
#include <plumb/shapes/aabb.h>
#include <plumb/space/space.h>

namespace plumb {

/// A shape, and the box that it is in now.
struct StaleBound {
    ProxyId proxy = 0;
    Aabb box;
};

/// Bounds are renewed when a step begins, for where bodies will be if nothing pushes them. Until the next step, a query
/// of the space has to look here, too. Worked out at the first query after a step; any number of threads may ask. What
/// was moved or removed since is still named: the space knows better.
class StaleBounds {
public:
    StaleBounds() = default;
    StaleBounds(const StaleBounds&) : known_(false) {}  // worked out anew
    StaleBounds& operator=(const StaleBounds&) {
        reset();
        return *this;
    }

    void reset() { known_ = false; }
    std::span<const StaleBound> of(const Space& space, const BodyStore& bodies) const;

private:
    mutable std::atomic<bool> known_ = true;
    mutable std::mutex mutex_;
    mutable std::vector<StaleBound> bounds_;
};

}  // namespace plumb
