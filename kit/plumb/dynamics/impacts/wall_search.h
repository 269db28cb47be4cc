// SPDX-License-Identifier: MIT
// Which wall has a body gone through first, during a part of the step?
//
// A wall is any static or kinematic body. A body has gone through it if it has crossed it, or if it is so deep in it
// that the way out is on the wrong side.
#pragma once
#include <optional>

#include <plumb/dynamics/contacts/contact_store.h>
#include <plumb/dynamics/impacts/body_motion.h>
#include <plumb/space/space.h>

namespace plumb {

/// The stores that the search reads.
struct WallView {
    const BodyStore& bodies;
    const ContactStore& contacts;
    const Space& space;
};

/// Where a body has met a wall.
struct WallHit {
    double time = 0;  ///< as a share of the sweep, 0 to 1 [-]
    BodyIndex wall = noBody;
    Sweep wallSweep;
    Vec2 shift{0, 0};  ///< to the wall's periodic image that was met, in a world that wraps [m]
};

class WallSearch {
public:
    /// way: must outlive the search.
    WallSearch(const WallView& view, BodyIndex body, const Sweep& way, const Past& past)
        : view_(view), body_(body), sweep_(way), past_(past) {}

    const std::optional<WallHit>& first() const { return first_; }

    /// Each call searches more walls: the wall of a contact, all static bodies, all kinematic bodies.
    void searchContact(ContactIndex contact);
    void searchStatic();
    void searchKinematic();

    /// Is the body still within the bounds for which its contacts were made? It may not be, if it was pushed or
    /// deflected.
    bool isWithinBounds() const;

private:
    void meet(ProxyId own, ProxyId other, const Vec2& shift, const RayPart& part = {});
    void meetAll(ProxyId other, const Vec2& shift, const RayPart& part = {});
    void meetNear(FunctionRef<void(const Space&, const Aabb&, Space::Visit)> query);
    void meetAlongPeriods(FunctionRef<bool(const Proxy&)> wanted);
    Verdict verdictOn(ProxyId own, ProxyId other, const Vec2& shift) const;
    bool isSolidAt(double time, const SweptShape& wall, const SweptShape& swept, ProxyId own, ProxyId other) const;
    RayPart partNear(ProxyId other, const Vec2& shift) const;

    WallView view_;
    BodyIndex body_;
    const Sweep& sweep_;
    Past past_;
    std::optional<WallHit> first_;
};

/// A wall's sweep, and the rotations into its frame at both ends.
struct WallSweep {
    Sweep sweep;
    Rot toWallBefore, toWallAfter;

    explicit WallSweep(const Sweep& w)
        : sweep(w),
          toWallBefore(Rot::fromAngle(w.angle).inverse()),
          toWallAfter(w.turn == 0 ? toWallBefore : Rot::fromAngle(w.angle + w.turn).inverse()) {}
};

/// May a body with this sweep have gone through this shape of a wall? A fast test with bounds only.
bool mayCross(const WallSweep& wall, const Sweep& way, const Shape& face, const BodyRecord& body);

}  // namespace plumb
