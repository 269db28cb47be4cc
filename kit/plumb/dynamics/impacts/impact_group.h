// SPDX-License-Identifier: MIT
// What happens when bodies in free motion hit each other, or a wall, one pair at a time?
//
// Each body moves by the closed form of free motion. The search finds the earliest time at which a pair meets, moves
// the two bodies there, applies the closed form of impact, and goes on with the rest of the step. All in double
// precision, as in a textbook.
#pragma once
#include <span>

#include <plumb/dynamics/bodies/free_motion.h>
#include <plumb/dynamics/bodies/step_observer.h>
#include <plumb/dynamics/contacts/touch_events.h>
#include <plumb/dynamics/fields/field_store.h>

namespace plumb {

/// The stores that impacts read and write.
struct ImpactStores {
    ContactStore& contacts;
    BodyStore& bodies;
    FieldStore& fields;
    const Space& space;
    StepObserver* observer = nullptr;  ///< may be null
};

/// The results of all impacts of a step.
struct Impacts {
    Trajectories trajectories;
    TouchEvents touches;
};

/// Moves the bodies of these contacts, and no others, through the step. If there are too many impacts, as in a pile, it
/// changes nothing and returns false. Impacts faster than hitSpeed [m/s] are hits.
bool moveThroughImpacts(const ImpactStores& stores, std::span<const ContactIndex> contacts, double dt, double hitSpeed,
                        Impacts& impacts);

}  // namespace plumb
