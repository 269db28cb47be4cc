// SPDX-License-Identifier: MIT
// Which shapes may a body meet after an impact, though its bounds did not overlap with theirs?
//
// A shape's bounds contain its predicted path in this step, and bounces of its own. A body that another one makes
// faster may leave them.
#pragma once
#include <vector>

#include <plumb/dynamics/impacts/flying_bodies.h>
#include <plumb/math/detail/step_list.h>

namespace plumb {

class Reach {
public:
    Reach(ImpactStores& stores, double dt) : stores_(stores), dt_(dt) {}

    /// If the rest of a body's flight leaves its bounds: makes a contact with each shape there, and adds it to a list.
    void extend(const FlyingBody& body, StepList<ContactIndex>& added);

private:
    /// A shape that will leave its bounds, and the box of the rest of its path.
    struct Leaving {
        ProxyId proxy = 0;
        Aabb box;
    };

    Aabb sweptBoxOf(const FlyingBody& body, ProxyId proxy) const;
    void meet(ProxyId own, ProxyId other, const Vec2& shift, StepList<ContactIndex>& added);

    ImpactStores& stores_;
    double dt_;
    StepList<Leaving> leaving_;
};

}  // namespace plumb
