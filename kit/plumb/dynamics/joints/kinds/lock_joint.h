// SPDX-License-Identifier: MIT
// How is a body kept from moving along x or y? By a sliding joint to the world.
#pragma once
#include <plumb/dynamics/joints/joint_form.h>
#include <plumb/dynamics/joints/joint_rows.h>

namespace plumb {

/// Made by the world for BodyDef.lockX and lockY; no user sees it.
class LockJoint {
public:
    AnchorPair anchors;

    LockJoint(BodyIndex body, bool lockX, bool lockY, const BodyStore& bodies)
        : anchors{{bodies.motion[body].center, noBody}, {{0, 0}, body}}, x_(lockX), y_(lockY) {}

    void addRows(JointRows& rows, const Ends& now, const JointPass& pass) const {
        const Vec2 off = now.apart(), later = ahead(now, pass).apart();
        if (x_) holdRow(rows, rowAlong({1, 0}, now), {off.x(), later.x()}, now, pass);
        if (y_) holdRow(rows, rowAlong({0, 1}, now), {off.y(), later.y()}, now, pass);
    }
    JointForm form() const {
        JointForm form(anchors);
        if (x_) form.add(RowAxis::World, Vec2(1, 0));
        if (y_) form.add(RowAxis::World, Vec2(0, 1));
        return form;
    }
    static double coordinate(const Ends&) { return 0; }
    static JointRow coordinateRow(const Ends&) { return {}; }
    double error(const Ends& ends) const {
        return Vec2(x_ ? ends.apart().x() : 0.0, y_ ? ends.apart().y() : 0.0).norm();
    }
    void moveTo(const Vec2& center) { anchors.a.local = center; }

private:
    bool x_ = false, y_ = false;
};

}  // namespace plumb
