// SPDX-License-Identifier: MIT
// Which wall has a body gone through first, during a part of the step?
//
// A wall is any static or kinematic body. A body has gone through it if it has crossed it, or if it is so deep in it
// that the way out is on the wrong side.
#pragma once
#include <algorithm>
#include <optional>

#include <plumb/dynamics/bodies/free_motion.h>
#include <plumb/dynamics/contacts/contact_store.h>
#include <plumb/space/detail/space.h>

namespace plumb {

/// A body may be this deep in a wall, as a share of its inradius [-], and at most deepest [m]: up to there, springs of
/// contacts push it out. Deeper, the nearest way out might be on the other side.
inline double deepIn(double inradius) {
    constexpr double deepShare = 0.25, deepest = 0.02;
    return std::min(deepShare * inradius, deepest);
}

/// The stores that the search reads.
struct WallView {
    const BodyStore& bodies;
    const ContactStore& contacts;
    const Space& space;
};

/// Where a body has met a wall.
struct WallHit {
    double time = 0;            ///< as a share of the sweep, 0 to 1 [-]
    ProxyId own = 0, wall = 0;  ///< the two shapes
    Sweep wallSweep;
    Vec2 shift{0, 0};   ///< to the wall's periodic image that was met, in a world that wraps [m]
    Manifold manifold;  ///< where they met, of the shape with the lower number and the other; empty if it
                        ///< spins so fast that the search ended before they met
};

class WallSearch {
public:
    /// sweep: its own in this part of the step; must outlive the search. far: what moves by less than this relative to
    /// a wall is taken not to pass it [m].
    WallSearch(const WallView& view, BodyIndex body, const Sweep& sweep, const StepPart& part, double far)
        : view_(view), body_(body), sweep_(sweep), part_(part), far_(far) {}

    const std::optional<WallHit>& first() const { return first_; }

    /// Each call searches more walls.
    void searchStatic();
    void searchKinematic();

private:
    void meet(ProxyId own, ProxyId other, const Vec2& shift, const RayPart& part = {});
    void meetAll(ProxyId other, const Vec2& shift, const RayPart& part = {});
    void meetNear(FunctionRef<void(const Aabb&, Space::Visit)> query);
    void meetAlongPeriods(FunctionRef<bool(const Proxy&)> wanted);
    Verdict verdictOn(ProxyId own, ProxyId other, const Vec2& shift) const;
    Manifold manifoldAt(double time, const Sweep& wallSweep, ProxyId own, ProxyId other) const;
    bool isLost(const WallHit& hit) const;
    bool approaches(const WallHit& hit) const;
    bool isSolidAt(double time, const SweptShape& wall, const SweptShape& swept, ProxyId own, ProxyId other) const;
    RayPart partNear(ProxyId other, const Vec2& shift) const;

    WallView view_;
    BodyIndex body_;
    const Sweep& sweep_;
    StepPart part_;
    double far_;
    std::optional<WallHit> first_;
};

/// Visits the shapes of kinematic bodies whose bounds overlap a box.
void forEachKinematicNear(const WallView& view, const Aabb& box, Space::Visit visit);

/// The state of a body at a share of a sweep of this duration [s].
BodyMotion motionAt(const Sweep& sweep, double time, double duration);

/// A wall's sweep, and the rotations into its frame at both ends.
struct WallSweep {
    Sweep sweep;
    Rot toWallBefore, toWallAfter;

    explicit WallSweep(const Sweep& w)
        : sweep(w),
          toWallBefore(Rot::fromAngle(w.angle).inverse()),
          toWallAfter(w.turn == 0 ? toWallBefore : Rot::fromAngle(w.angle + w.turn).inverse()) {}
};

/// An upper bound on how far a body moves relative to a wall, if it may touch a shape of it on its way; else 0. A fast
/// test with bounds only [m].
double travelTowards(const WallSweep& wall, const Sweep& sweep, const Shape& face, const BodyRecord& body);

}  // namespace plumb
