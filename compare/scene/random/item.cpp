// SPDX-License-Identifier: MIT
#include <compare/scene/random/item.h>

#include <string>

#include <plumb/math/trig.h>

namespace plumb::compare {
namespace {

Vec2 turnedBy(const SinCos& angle, const Vec2& v) {
    return angle.cos * v + angle.sin * perp(v);
}

/// The machines here have hinges and wheels only.
RevoluteJointDef* hingeOf(JointDef& def) {
    return std::get_if<RevoluteJointDef>(&def);
}

}  // namespace

Item turned(Item item, double angle) {
    const SinCos by = sinCos(angle);
    for (SceneBody& body : item.bodies) {
        body.def.position = turnedBy(by, body.def.position);
        body.def.angle += angle;
    }
    for (SceneJoint& joint : item.joints) {
        if (RevoluteJointDef* hinge = hingeOf(joint.def)) {
            hinge->anchor = turnedBy(by, hinge->anchor);
        } else {
            auto& wheel = std::get<WheelJointDef>(joint.def);
            wheel.anchor = turnedBy(by, wheel.anchor);
            wheel.axis = turnedBy(by, wheel.axis);
        }
    }
    return item;
}

void addItem(Scene& scene, const Item& item, const Vec2& origin) {
    const std::string name = "body_" + std::to_string(scene.bodies.size());
    const auto nameOf = [&](const std::string& own) {
        return own == worldName ? own : item.bodies.size() == 1 ? name : name + "_" + own;
    };
    for (SceneBody body : item.bodies) {
        body.name = nameOf(body.name);
        body.def.position += origin;
        scene.bodies.push_back(std::move(body));
    }
    for (SceneJoint joint : item.joints) {
        joint.name = name + "_" + joint.name;
        joint.bodyA = nameOf(joint.bodyA);
        joint.bodyB = nameOf(joint.bodyB);
        if (RevoluteJointDef* hinge = hingeOf(joint.def))
            hinge->anchor += origin;
        else
            std::get<WheelJointDef>(joint.def).anchor += origin;
        scene.joints.push_back(std::move(joint));
    }
}

}  // namespace plumb::compare
