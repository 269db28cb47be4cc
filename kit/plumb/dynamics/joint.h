// SPDX-License-Identifier: MIT
// What does a joint do, and how can it be changed?
#pragma once
#include <plumb/dynamics/joint_def.h>

namespace plumb {

struct WorldState;

/// What a joint does to hold its bodies, as means over the last step.
struct JointReaction {
    Vec2 force{0, 0};   ///< on bodyB, at its anchor [N]
    double torque = 0;  ///< on bodyB [N m]
};

/// A joint's own coordinate: the angle of a hinge or weld, the shift of a slide or of a wheel's hub, the distance of
/// two anchors, lengthA + ratio lengthB of a pulley, a + ratio b of a gear, how far a motor joint or a target is off.
struct JointCoordinate {
    double value = 0;  ///< [m or rad]
    double speed = 0;  ///< [m/s or rad/s]
};

/// A view of one joint of a world, which may not change it; valid while the joint and its world are.
class JointView {
public:
    JointDef def() const;  ///< as it was given, and as it was set since
    JointReaction reaction() const;
    JointCoordinate coordinate() const;
    double error() const;  ///< how far the anchors are from where the joint wants them: what joint_error_max is of [m]
    double angleError() const;  ///< how far the bodies are turned from what it lets them turn [rad]

protected:
    friend class World;
    JointView(WorldState& world, std::uint32_t index) : world_(&world), index_(index) {}
    WorldState* world_;
    std::uint32_t index_;
};

/// The same, and changes it.
class Joint : public JointView {
public:
    /// Motors, limits, springs, targets, ratios, lengths and what it takes to break, and wakes the bodies. Throws
    /// std::invalid_argument, and changes nothing, unless kind, bodies, anchors and axes are those it has: for others,
    /// remove it and join anew.
    void set(const JointDef& def);
    /// set() with another motorSpeed: of a hinge or a wheel [rad/s], of a slide or a distance joint [m/s]. Throws
    /// std::invalid_argument, and changes nothing, for a joint of another kind or a speed that its def may not have.
    void setMotorSpeed(double speed);

private:
    friend class World;
    using JointView::JointView;
};

}  // namespace plumb
