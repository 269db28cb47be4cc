// SPDX-License-Identifier: MIT
// Which joints does the world have, which data is kept for each, and on which bodies do they act?
#pragma once
#include <algorithm>
#include <cmath>
#include <concepts>
#include <type_traits>
#include <variant>
#include <vector>

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
#include <plumb/math/detail/arrays.h>

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

/// The bodies of a joint, in the order of its rows' ends: two, or up to four of a gear. noBody where there is none; one
/// body may occur twice.
inline std::array<BodyIndex, maxEnds> endsOf(const JointStore& joints, JointIndex index) {
    const JointRecord& record = joints[index];
    const auto* gear = std::get_if<GearJoint>(&record.joint);
    if (gear == nullptr) return {record.bodyA, record.bodyB, noBody, noBody};
    return {record.bodyA, record.bodyB, joints[gear->jointA].bodyA, joints[gear->jointB].bodyA};
}

/// Calls visit(body) for each of them once.
template <class Visit>
void forEachBody(const JointStore& joints, JointIndex index, Visit&& visit) {
    const std::array<BodyIndex, maxEnds> ends = endsOf(joints, index);
    for (auto end = ends.begin(); end != ends.end(); ++end)
        if (*end != noBody && std::find(ends.begin(), end, *end) == end) visit(*end);
}

/// Does the joint have a body that it can move, and are all its bodies in the valid range of positions?
inline bool holdsSomething(const JointStore& joints, const BodyStore& bodies, JointIndex index) {
    const std::array<BodyIndex, maxEnds> ends = endsOf(joints, index);
    return std::any_of(ends.begin(), ends.end(), [&](BodyIndex body) { return bodies.canMove(body); }) &&
           std::all_of(ends.begin(), ends.end(), [&](BodyIndex body) { return isInRange(bodies.motion[body]); });
}

/// Does something that should move at a speed follow it? It does at half of that speed, and at enough.
inline bool follows(double speed, double wanted, double enough) {
    const double along = wanted < 0 ? -speed : speed;
    return wanted != 0 && along > std::min(0.5 * std::fabs(wanted), enough);
}

/// Has the joint a motor with a target speed, and does it move its body that way? It does not if something stops it.
/// enough: the speed at which it runs, even if it is slow for its target [m/s or rad/s].
bool isMotorRunning(const JointStore& joints, const BodyStore& bodies, JointIndex joint, double enough);

}  // namespace plumb
