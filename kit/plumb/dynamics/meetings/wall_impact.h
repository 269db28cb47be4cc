// SPDX-License-Identifier: MIT
// Which impulses act where a body meets a wall, and which contact and which events do they leave?
//
// The law is that of kit/plumb/impact, for whatever the impulses push: a body alone, or a body of a mechanism, whose
// response at the point includes that of its joints. Points that approach the wall are solved one after the other.
#pragma once
#include <plumb/dynamics/contacts/contact_graph.h>
#include <plumb/dynamics/contacts/touch_events.h>
#include <plumb/dynamics/meetings/wall_search.h>
#include <plumb/math/detail/arrays.h>

namespace plumb {

class StepObserver;

/// A body that a wall pushes. An impulse, or a change of velocity, has three parts: along x, along y, turning.
class PushedBody {
public:
    virtual ~PushedBody() = default;
    /// Its state where it meets the wall, with all impulses so far.
    virtual BodyMotion motion() const = 0;
    /// By how much an impulse would change its velocity.
    virtual Vec3 responseTo(const Vec3& impulse) = 0;
    virtual void push(const Vec3& impulse) = 0;
};

/// What happened where a body met a wall.
struct WallImpact {
    WallHit hit;
    Vec2 point{0, 0}, normal{0, 1};  ///< in the world; normal: from the wall to the body
    double approachSpeed = 0;        ///< [m/s]
    double normalImpulse = 0, tangentImpulse = 0;
    double friction = 0, drivers = 0, bounce = 0;  ///< as in StepObserver::noteImpact [J]
    Vec2 impulse{0, 0};                            ///< on the body [N s]
};

/// Pushes the body at the place of a hit, until nothing there approaches the wall; duration: of the sweep in which the
/// hit was found [s]. The impulses are 0 if nothing approached.
WallImpact solveWallImpact(const WallView& view, const WallHit& hit, double duration, PushedBody& body);

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
