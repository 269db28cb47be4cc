// SPDX-License-Identifier: MIT
// What happens when bodies in free flight hit each other, or a wall, one pair at a time?
//
// Each body moves on its closed form; the earliest time at which a pair meets is found on those, the two are moved
// there and parted by the closed form of impact, and the search goes on with the rest of the step: as the textbook
// does it, in double precision.
#pragma once
#include <span>

#include <plumb/dynamics/bodies/free_motion.h>
#include <plumb/dynamics/bodies/step_observer.h>
#include <plumb/dynamics/contacts/touch_events.h>
#include <plumb/dynamics/fields/field_store.h>

namespace plumb {

/// What impacts read and write.
struct ImpactStores {
    ContactStore& contacts;
    BodyStore& bodies;
    FieldStore& fields;
    const ContactGraph& graph;
    const Space& space;
    StepObserver* observer = nullptr;  ///< if there is one
};

/// What impacts have done in a step.
struct Impacts {
    Trajectories trajectories;
    TouchEvents touches;
};

/// Moves the bodies of these contacts, and no others, through the step. False, and nothing done, when there were so
/// many impacts that it is rather a heap than a flight. Impacts faster than hitSpeed [m/s] are hits.
bool moveThroughImpacts(const ImpactStores& stores, std::span<const ContactIndex> contacts, double dt, double hitSpeed,
                        Impacts& impacts);

}  // namespace plumb
