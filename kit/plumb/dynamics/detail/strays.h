// SPDX-License-Identifier: MIT
// Which shapes has the last step moved out of the boxes that the space has for them?
#pragma once
#include <atomic>
#include <mutex>
#include <span>
#include <vector>

#include <plumb/shapes/aabb.h>
#include <plumb/space/space.h>

namespace plumb {

struct WorldState;

/// A shape and the box that holds it.
struct Stray {
    ProxyId proxy = 0;
    Aabb box;
};

/// Boxes are renewed when a step begins, for where bodies will be if nothing pushes them. Until the next step, whoever
/// asks the space has to ask here, too. Worked out when somebody asks for the first time after a step; any number of
/// threads may ask. What was moved or removed since is still named: the space knows better.
class Strays {
public:
    Strays() = default;
    Strays(const Strays&) : known_(false) {}  // worked out anew
    Strays& operator=(const Strays&) {
        forget();
        return *this;
    }

    void forget() { known_ = false; }
    std::span<const Stray> of(const WorldState& world) const;

private:
    mutable std::atomic<bool> known_ = true;
    mutable std::mutex mutex_;
    mutable std::vector<Stray> strays_;
};

/// Has one of the body's shapes?
bool hasLeftItsBoxes(const WorldState& world, std::uint32_t body);

}  // namespace plumb
