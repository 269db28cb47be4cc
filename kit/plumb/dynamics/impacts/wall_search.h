// SPDX-License-Identifier: MIT
// Which wall has a body gone through first on its way through a part of the step?
//
// A wall is anything static or kinematic. A body has gone through it when it has crossed it, or is so deep in it that
// the way out is on the wrong side.
#pragma once
#include <optional>

#include <plumb/dynamics/contacts/contact_store.h>
#include <plumb/dynamics/impacts/body_motion.h>
#include <plumb/space/space.h>

namespace plumb {

/// What the search reads.
struct WallView {
    const BodyStore& bodies;
    const ContactStore& contacts;
    const Space& space;
};

/// Where a body has met a wall.
struct WallHit {
    double time = 0;  ///< as a share of its way [-]
    BodyIndex wall = noBody;
    Sweep wallWay;
    Vec2 shift{0, 0};  ///< of the wall, in a world that wraps [m]
};

class WallSearch {
public:
    /// way: must outlive the search.
    WallSearch(const WallView& view, BodyIndex body, const Sweep& way, const Past& past)
        : view_(view), body_(body), way_(way), past_(past) {}

    const std::optional<WallHit>& first() const { return first_; }

    /// Each looks at more walls: that of a contact, all that is static, all that is kinematic.
    void searchContact(ContactIndex contact);
    void searchStatic();
    void searchKinematic();

    /// Is the body still in the bounds for which its contacts were made? Not if it was pushed or deflected.
    bool isWithinBounds() const;

private:
    void meet(ProxyId own, ProxyId other, const Vec2& shift, const RayPart& part = {});
    void meetAll(ProxyId other, const Vec2& shift, const RayPart& part = {});
    void meetNear(FunctionRef<void(const Space&, const Aabb&, Space::Visit)> query);
    void meetAround(FunctionRef<bool(const Proxy&)> wanted);
    Verdict verdictOn(ProxyId own, ProxyId other, const Vec2& shift) const;
    bool isSolidAt(double time, const SweptShape& wall, const SweptShape& swept, ProxyId own, ProxyId other) const;
    RayPart partNear(ProxyId other, const Vec2& shift) const;
    bool goesRound() const;

    WallView view_;
    BodyIndex body_;
    const Sweep& way_;
    Past past_;
    std::optional<WallHit> first_;
};

/// A wall's way, and how it is turned at both ends.
struct WallWay {
    Sweep sweep;
    Rot toWallBefore, toWallAfter;

    explicit WallWay(const Sweep& w)
        : sweep(w),
          toWallBefore(Rot::fromAngle(w.angle).inverse()),
          toWallAfter(w.turn == 0 ? toWallBefore : Rot::fromAngle(w.angle + w.turn).inverse()) {}
};

/// May a body on a way have gone through a shape of a wall?
bool mayCross(const WallWay& wall, const Sweep& way, const Shape& face, const BodyRecord& body);

}  // namespace plumb
