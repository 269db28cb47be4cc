// SPDX-License-Identifier: MIT
// Which bounding box must a shape have in the space, so that everything it may meet in a step is found? And which
// shapes has the last step moved out of theirs?
#pragma once
#include <atomic>
#include <span>
#include <vector>

#include <plumb/dynamics/bodies/body_store.h>
#include <plumb/dynamics/contacts/contact_store.h>
#include <plumb/shapes/aabb.h>
#include <plumb/space/detail/space.h>

namespace plumb {

/// The displacement of a body in this step, if nothing touches it, for which its bounds are made [m]. It is zero for a
/// body that moves farther than a period of a world that wraps: such a body is still stopped at walls on its path, but
/// meets other bodies only at the places where its steps begin.
Vec2 predictedShift(const BodyStore& bodies, BodyIndex body);
/// How far a body has come outside of the path for which its bounds were made: its centre beside the path from the
/// step's start to the predicted place, and its outline by a larger turn [m]. moved: the centre's displacement [m];
/// turned: how far the turn has moved its outline at most [m].
double excessOfPrediction(const BodyStore& bodies, BodyIndex body, const Vec2& moved, double turned);
/// Updates the bounds of one body's shapes for a step of dt [s].
void placeBounds(Space& space, const BodyStore& bodies, const ContactStore& contacts, BodyIndex body, double dt);
/// Loads all bodies that are awake (see load_bodies.h), and updates the bounds of those that are in range: body by
/// body, while its data is in the cache.
void loadBodies(BodyStore& bodies, Space& space, const ContactStore& contacts, double dt);
/// Has a shape of the body moved out of its bounds?
bool hasLeftItsBounds(const Space& space, const BodyStore& bodies, BodyIndex body);

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
