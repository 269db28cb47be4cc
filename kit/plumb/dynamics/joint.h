// SPDX-License-Identifier: MIT
// What are a joint's forces and position, and how can it be changed?
#pragma once
#include <plumb/dynamics/joint_def.h>

namespace plumb {

struct WorldState;

/// The force and torque of a joint on its bodies, as means over the last step.
struct JointReaction {
    Vec2 force{0, 0};   ///< on bodyB, at its anchor [N]
    double torque = 0;  ///< on bodyB [N m]
};

/// A joint's own coordinate: the angle of a hinge or weld, the shift of a slide or of a wheel's hub, the distance of
/// two anchors, lengthA + ratio lengthB of a pulley, a + ratio b of a gear, the distance from the target of a motor or
/// target joint.
struct JointCoordinate {
    double value = 0;  ///< [m or rad]
    double speed = 0;  ///< [m/s or rad/s]
};

/// A read-only view of one joint of a world. Valid as long as the world exists; each call
/// throws std::invalid_argument once the joint was removed.
class JointView {
public:
    JointId id() const;
    JointDef def() const;  ///< as given or last set
    JointReaction reaction() const;
    JointCoordinate coordinate() const;
    /// Distance of the anchors from where the joint should hold them; see joint_error_max. Always finite: the greatest
    /// double for a body so far out of range that its distance is not known [m].
    double error() const;
    double angleError() const;  ///< angle of the bodies beyond what the joint allows [rad]

protected:
    friend class World;
    JointView(WorldState& world, JointId id) : world_(&world), id_(id) {}
    std::uint32_t index() const;  ///< the slot; throws std::invalid_argument if it was removed
    WorldState* world_;
    JointId id_;
};

/// A view that can also change the joint.
class Joint : public JointView {
public:
    /// Changes motors, limits, springs, targets, ratios, lengths and breaking loads, and wakes the bodies. Throws
    /// std::invalid_argument, and changes nothing, if kind, bodies, anchors or axes differ from the joint's: to change
    /// those, remove the joint and make another.
    void set(const JointDef& def);
    /// Same as set() with another motorSpeed: of a hinge or a wheel [rad/s], of a slide or a distance joint [m/s].
    /// Throws std::invalid_argument, and changes nothing, for a joint of another kind, for a speed that is not allowed,
    /// and for one that does nothing because the motor's greatest torque or force is 0.
    void setMotorSpeed(double speed);

private:
    friend class World;
    using JointView::JointView;
};

}  // namespace plumb
