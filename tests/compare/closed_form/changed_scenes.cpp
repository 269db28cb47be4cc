// SPDX-License-Identifier: MIT
#include "compare/closed_form/changed_scenes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

namespace plumb::compare {
namespace {

/// Each changes a scene by a factor, and says whether there was anything to change.
using Change = std::function<bool(Scene&, double)>;

Vec2 turnedBy(const Vec2& v, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

bool changeMass(Scene& scene, double factor) {
    for (const BodyMotion& motion : scene.closedForm->bodies) {
        const std::string& name = std::visit([](const auto& m) -> const std::string& { return m.body; }, motion);
        BodyDef& def = std::ranges::find(scene.bodies, name, &SceneBody::name)->def;
        if (def.type != BodyType::Dynamic) continue;
        for (ShapeDef& shape : def.shapes) shape.material.density *= factor;
        if (def.mass) def.mass->mass *= factor, def.mass->inertia *= factor;
        return true;
    }
    return false;
}

bool changeMaterials(Scene& scene, double Material::*number, double factor) {
    bool any = false;
    for (SceneBody& body : scene.bodies)
        for (ShapeDef& shape : body.def.shapes) {
            any = any || shape.material.*number > 0;
            shape.material.*number *= factor;
        }
    return any;
}

bool changeRestitution(Scene& scene, double factor) {
    if (!changeMaterials(scene, &Material::restitution, factor)) return false;
    for (const SceneBody& body : scene.bodies)
        for (const ShapeDef& shape : body.def.shapes)
            if (shape.material.restitution > 1) return false;
    return true;
}

bool changeGravity(Scene& scene, double factor) {
    scene.gravity *= factor;
    return scene.gravity.norm() > 0;
}

bool changeSpeed(Scene& scene, double factor) {
    bool any = false;
    for (SceneBody& body : scene.bodies) {
        any = any || body.def.velocity.norm() + std::abs(body.def.angularVelocity) > 0;
        body.def.velocity *= factor;
        body.def.angularVelocity *= factor;
    }
    return any && scene.movers.empty();
}

bool changeDamping(Scene& scene, double factor) {
    bool any = false;
    const auto scale = [&](double& number) {
        any = any || number > 0;
        number *= factor;
    };
    for (SceneBody& body : scene.bodies) scale(body.def.linearDamping);
    for (SceneField& field : scene.fields)
        if (auto* air = std::get_if<Drag>(&field.def.law)) scale(air->linear), scale(air->quadratic);
    for (SceneJoint& joint : scene.joints)
        if (auto* spring = std::get_if<DistanceJointDef>(&joint.def); spring && spring->spring)
            scale(spring->spring->damping);
    return any;
}

/// All that is there, about the origin: another slope under the same gravity.
bool changeSlope(Scene& scene, double factor) {
    static const std::map<std::string, double> slopes{
        {"block_slides", 30},    {"block_sticks", 30}, {"disc_rolls", 30}, {"disc_rolls_down", 20},
        {"ring_rolls_down", 20}, {"tip_below", 26},    {"tip_above", 27}};
    const auto slope = slopes.find(scene.name);
    if (slope == slopes.end()) return false;
    const double by = -(factor - 1) * slope->second * std::numbers::pi / 180;
    for (SceneBody& body : scene.bodies) {
        body.def.position = turnedBy(body.def.position, by);
        body.def.angle += by;
    }
    return true;
}

/// Those that are swung out, about what they hang from.
bool changeSwing(Scene& scene, double factor) {
    bool any = false;
    for (SceneJoint& joint : scene.joints) {
        auto* hinge = std::get_if<RevoluteJointDef>(&joint.def);
        auto* rod = std::get_if<DistanceJointDef>(&joint.def);
        if (joint.bodyA != "pivot" || (!hinge && (!rod || rod->spring))) continue;
        const Vec2 pivot = hinge ? hinge->anchor : rod->anchorA;
        BodyDef& def = std::ranges::find(scene.bodies, joint.bodyB, &SceneBody::name)->def;
        const Vec2 arm = def.position - pivot;
        const double by = (factor - 1) * std::atan2(arm.x(), -arm.y());
        if (std::abs(by) < 1e-9 || std::abs(by + std::atan2(arm.x(), -arm.y())) > 3) continue;
        def.position = pivot + turnedBy(arm, by);
        def.angle += by;
        if (rod) rod->anchorB = def.position;
        any = true;
    }
    const BodyMotion& first = scene.closedForm->bodies[0];
    return any && !std::holds_alternative<RestsMotion>(first) && !std::holds_alternative<CaughtMotion>(first);
}

bool changeShot(Scene& scene, double factor) {
    bool any = false;
    for (SceneBody& body : scene.bodies) {
        const Vec2 v = body.def.velocity;
        if (v.x() == 0 || v.y() == 0) continue;
        body.def.velocity = turnedBy(v, (factor - 1) * std::atan2(v.y(), v.x()));
        any = true;
    }
    return any;
}

}  // namespace

std::vector<ChangedScene> changedScenes(const Scene& scene) {
    const auto changeFriction = [](Scene& s, double factor) { return changeMaterials(s, &Material::friction, factor); };
    const std::vector<std::pair<std::string, Change>> changes{
        {"mass", changeMass},       {"friction", changeFriction}, {"restitution", changeRestitution},
        {"gravity", changeGravity}, {"speed", changeSpeed},       {"damping", changeDamping},
        {"angle", changeSlope},     {"angle", changeSwing},       {"angle", changeShot}};
    std::vector<ChangedScene> changed;
    for (const auto& [what, change] : changes)
        for (const double factor : {0.8, 1.2}) {
            Scene other = scene;
            if (change(other, factor)) changed.push_back({what, factor, other});
        }
    return changed;
}

}  // namespace plumb::compare
