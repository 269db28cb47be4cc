// SPDX-License-Identifier: MIT
#include <compare/engine/plumb_pushes.h>

#include <algorithm>
#include <map>
#include <variant>

#include <plumb/math/vec2.h>

namespace plumb::compare {
namespace {

using Places = std::map<std::uint32_t, std::size_t>;  // of the scene's bodies, by the index of their ids

Places placesOf(const PlumbWorld& made) {
    Places places;
    for (std::size_t i = 0; i < made.bodies.size(); ++i)
        if (made.world.contains(made.bodies[i])) places[made.bodies[i].index] = i;
    return places;
}

void addContacts(const PlumbWorld& made, const Places& places, std::size_t body, std::vector<Push>& pushes) {
    for (const Contact& contact : made.world.body(made.bodies[body]).contacts()) {
        const bool isB = contact.shapeB.body == made.bodies[body];
        const auto other = places.find(isB ? contact.shapeA.body.index : contact.shapeB.body.index);
        if (other == places.end()) continue;
        const double side = isB ? 1 : -1;
        const Vec2 along(-contact.normal.y(), contact.normal.x());
        for (const ContactPoint& point : contact.points) {
            pushes.push_back(
                {Cause::Normal, body, other->second, point.position, side * point.normalForce * contact.normal});
            pushes.push_back(
                {Cause::Friction, body, other->second, point.position, side * point.frictionForce * along});
        }
    }
}

/// The rope of a pulley draws both bodies to its wheels: the force on A is not the opposite of that on B.
Vec2 forceOnA(const PlumbWorld& made, const JointGeometry& joint, const Vec2& forceOnB) {
    const auto* pulley = std::get_if<PulleyJointDef>(&joint.def);
    if (pulley == nullptr) return -forceOnB;
    const Vec2 anchor = made.world.body(made.bodies[joint.bodyA]).pose() * joint.localAnchorA;
    return forceOnB.norm() / pulley->ratio * (pulley->groundA - anchor).normalized();
}

void addJoints(const PlumbWorld& made, std::vector<Push>& pushes) {
    for (std::size_t i = 0; i < made.geometries.size(); ++i) {
        const JointGeometry& joint = made.geometries[i];
        if (joint.bodyB == noBody || !made.world.contains(made.joints[i])) continue;
        const Vec2 force = made.world.joint(made.joints[i]).reaction().force;
        const auto on = [&](std::size_t body, const Vec2& anchor, const Vec2& push) {
            const BodyView view = made.world.body(made.bodies[body]);
            if (view.type() != BodyType::Dynamic) return;
            pushes.push_back({Cause::Joint, body, i, view.pose() * anchor, push});
        };
        on(joint.bodyB, joint.localAnchorB, force);
        if (joint.bodyA != noBody) on(joint.bodyA, joint.localAnchorA, forceOnA(made, joint, force));
    }
}

}  // namespace

std::vector<Push> plumbPushes(const PlumbWorld& made) {
    std::vector<Push> pushes;
    const Places places = placesOf(made);
    for (const auto& [id, body] : places)
        if (made.world.body(made.bodies[body]).type() == BodyType::Dynamic) addContacts(made, places, body, pushes);
    addJoints(made, pushes);
    return pushes;
}

}  // namespace plumb::compare
