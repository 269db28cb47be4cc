// SPDX-License-Identifier: MIT
// Which joints does the world have, and which data is kept for each?
#pragma once
#include <concepts>
#include <type_traits>
#include <variant>
#include <vector>

#include <plumb/dynamics/joints/joint_rows.h>
#include <plumb/dynamics/joints/kinds/distance_joint.h>
#include <plumb/dynamics/joints/kinds/filter_joint.h>
#include <plumb/dynamics/joints/kinds/gear_joint.h>
#include <plumb/dynamics/joints/kinds/lock_joint.h>
#include <plumb/dynamics/joints/kinds/motor_joint.h>
#include <plumb/dynamics/joints/kinds/prismatic_joint.h>
#include <plumb/dynamics/joints/kinds/pulley_joint.h>
#include <plumb/dynamics/joints/kinds/revolute_joint.h>
#include <plumb/dynamics/joints/kinds/target_joint.h>
#include <plumb/dynamics/joints/kinds/weld_joint.h>
#include <plumb/dynamics/joints/kinds/wheel_joint.h>

namespace plumb {

using JointIndex = std::uint32_t;

/// monostate: a free slot.
using AnyJoint = std::variant<std::monostate, RevoluteJoint, PrismaticJoint, DistanceJoint, WeldJoint, WheelJoint,
                              PulleyJoint, GearJoint, MotorJoint, TargetJoint, LockJoint, FilterJoint>;

/// The kind of joint that a definition describes: the one of AnyJoint whose def() returns it.
template <class Def, class Any = AnyJoint>
struct KindOf;
template <class Def, class... Joints>
struct KindOf<Def, std::variant<Joints...>> {
    template <class Joint>
    static constexpr bool isIt = requires(const Joint& joint) {
        { joint.def() } -> std::same_as<const Def&>;
    };
    template <class First, class... Rest>
    static auto find() {
        if constexpr (isIt<First>)
            return std::type_identity<First>{};
        else
            return find<Rest...>();
    }
    using type = typename decltype(find<Joints...>())::type;
};

/// Impulses on B in the last step in which the joint was solved, and the length of that step.
struct JointLoad {
    Vec2 impulse{0, 0};  ///< [N s]
    double turning = 0;  ///< about B's anchor [N m s]
    double time = 0;     ///< [s]

    Vec2 force() const { return time > 0 ? Vec2(impulse / time) : Vec2(0, 0); }
    double torque() const { return time > 0 ? turning / time : 0.0; }
};

struct JointRecord {
    AnyJoint joint;
    BodyIndex bodyA = noBody, bodyB = noBody;  ///< noBody: the world; of a gear: the bodies B of its two joints
    bool collideConnected = false;
    std::uint32_t generation = 0;
    Breaking breaking;
    std::array<RowState, maxRows> states{};
    bool edited = true;      ///< since its island was laid out
    double springShare = 1;  ///< in this step (see joint_springs.h)
    Vec3 impulse{};          ///< of half a sub-step, if its island is swept [N s or N m s]

    bool isFree() const { return std::holds_alternative<std::monostate>(joint); }
    JointDef def() const;  ///< of a joint that is neither free nor hidden
    bool isHidden() const { return std::holds_alternative<LockJoint>(joint); }
    bool mayBreak() const { return breaking.force < unlimited || breaking.torque < unlimited; }
    bool acts() const { return !isFree() && !std::holds_alternative<FilterJoint>(joint); }
};

struct JointStore {
    std::vector<JointRecord> records;
    std::vector<JointLoad> loads;  ///< of the records; separate, because they are written every step
    std::vector<JointIndex> free;
    std::vector<JointIndex> gears;  ///< joints that are gears
    bool changed = false;           ///< the joint islands must be found again

    JointRecord& operator[](JointIndex joint) { return records[joint]; }
    const JointRecord& operator[](JointIndex joint) const { return records[joint]; }

    JointIndex acquire();
    void release(JointIndex joint);
    /// The joint has another form.
    void noteEdit(JointIndex joint);
    /// A body with these joints moves or turns by other rules.
    void noteEdits(const std::vector<JointIndex>& joints);

    JointForm formOf(JointIndex joint) const;
    bool hasSpring(JointIndex joint) const;
    /// The joint's coordinate after the last step [m or rad].
    double coordinateOf(JointIndex joint, const BodyStore& bodies) const;
    double speedOf(JointIndex joint, const BodyStore& bodies) const;       ///< [m/s or rad/s]
    double errorOf(JointIndex joint, const BodyStore& bodies) const;       ///< [m]
    double angleErrorOf(JointIndex joint, const BodyStore& bodies) const;  ///< [rad]
};

/// The joint that a def describes, at the bodies' present positions.
AnyJoint makeJoint(const JointDef& def, const JointStore& joints, const BodyStore& bodies);
/// Gives a joint another definition of its kind.
void changeJoint(AnyJoint& joint, const JointDef& def, const JointStore& joints, const BodyStore& bodies);

}  // namespace plumb
