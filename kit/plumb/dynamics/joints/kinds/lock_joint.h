// SPDX-License-Identifier: MIT
// How is a body kept from moving along x or y? By a sliding joint to the world.
#pragma once
#include <plumb/dynamics/joints/joint_form.h>

namespace plumb {

/// Made by the world for BodyDef.lockX and lockY; no user sees it.
class LockJoint {
public:
    AnchorPair anchors;

    LockJoint(BodyIndex body, bool lockX, bool lockY, const BodyStore& bodies)
        : anchors{{bodies.motion[body].center, noBody}, {{0, 0}, body}}, x_(lockX), y_(lockY) {}

    JointForm form() const {
        JointForm form(anchors);
        if (x_) form.add(RowAxis::World, Vec2(1, 0));
        if (y_) form.add(RowAxis::World, Vec2(0, 1));
        return form;
    }
    void setCenter(const Vec2& center) { anchors.a.local = center; }

private:
    bool x_ = false, y_ = false;
};

}  // namespace plumb
