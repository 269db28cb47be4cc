// SPDX-License-Identifier: MIT
// What happens where a body meets a wall, and which contact and which events does it leave?
#pragma once
#include <plumb/dynamics/contacts/contact_graph.h>
#include <plumb/dynamics/contacts/touch_events.h>
#include <plumb/dynamics/meetings/wall_search.h>
#include <plumb/impact/detail/meeting.h>

namespace plumb {

class StepObserver;

/// What happened where a body met a wall: the wall is A, the body B.
struct WallImpact : Meeting {
    WallHit hit;
    Vec2 point{0, 0}, normal{0, 1};  ///< in the world; normal: from the wall to the body
};

/// How the wall of a hit moves there; duration: of the sweep in which the hit was found [s].
BodyMotion wallMotionAt(const WallHit& hit, double duration);

/// Solves the impact of a wall with a body that is at the place of a hit. bodies: the wall and the body. The impulses
/// are 0 if nothing approached.
WallImpact solveWallImpact(const WallView& view, const WallHit& hit, const BodyMotion& wall, const BodyMotion& body,
                           MeetingBodies& bodies);

/// The stores that what meets reads and writes.
struct MeetingStores {
    ContactGraph& graph;
    ContactStore& contacts;
    BodyStore& bodies;
    const Space& space;
    StepObserver* observer = nullptr;  ///< may be null
};

/// Adds the impulses of an impact, in a step of dt [s], to the contact of its two shapes, which is made if there is
/// none, and adds its events. Impacts faster than hitSpeed [m/s] are hits.
void reportWallImpact(MeetingStores& stores, const WallImpact& impact, double dt, double hitSpeed,
                      TouchEvents& touches);

}  // namespace plumb
