// SPDX-License-Identifier: MIT
#include <compare/scene/builtin/doll.h>

#include <compare/scene/builtin/links.h>
#include <plumb/math/rot.h>

namespace plumb::compare {
namespace {

/// A limb from one point down to another. It is on a hinge at the first point, and may turn this far either way.
struct Limb {
    std::string name;
    std::string from;
    Vec2 top, end;
    double radius;
    Limit limit;
};

class Builder {
public:
    Builder(Scene& scene, const Doll& doll) : scene_(scene), doll_(doll) {}

    void addPart(const std::string& name, const Vec2& top, const Vec2& end, double radius) const {
        const Vec2 middle = (top + end) / 2;
        ShapeDef shape = capsule(top - middle, end - middle, radius, {.density = 500, .friction = 0.4});
        shape.filter.group = -doll_.group;
        scene_.bodies.push_back(
            {doll_.name + name, {.position = middle, .velocity = doll_.velocity, .shapes = {shape}}});
    }

    void addLimb(const Limb& limb) const {
        addPart(limb.name, limb.top, limb.end, limb.radius);
        auto& joint =
            hinge(scene_, doll_.name + limb.name + "_joint", doll_.name + limb.from, doll_.name + limb.name, limb.top);
        std::get<RevoluteJointDef>(joint.def).limit = limb.limit;
    }

private:
    Scene& scene_;
    const Doll& doll_;
};

void addUpright(Scene& scene, const Doll& doll) {
    const Builder builder(scene, doll);
    const Vec2 neck = doll.neck, hip = neck - Vec2(0, 0.6), shoulder = neck - Vec2(0, 0.05);
    const Vec2 upper(0, -0.3), lower(0, -0.28), thigh(0, -0.4), shin(0, -0.35);
    builder.addPart("torso", neck, neck - Vec2(0, 0.55), 0.13);
    builder.addLimb({"head", "torso", neck + Vec2(0, 0.05), neck + Vec2(0, 0.25), 0.11, {-0.5, 0.5}});
    for (const std::string side : {"left_", "right_"}) {
        builder.addLimb({side + "arm", "torso", shoulder, shoulder + upper, 0.05, {-2.5, 2.5}});
        builder.addLimb({side + "hand", side + "arm", shoulder + upper, shoulder + upper + lower, 0.04, {0, 2.4}});
        builder.addLimb({side + "thigh", "torso", hip, hip + thigh, 0.07, {-0.5, 1.8}});
        builder.addLimb({side + "shin", side + "thigh", hip + thigh, hip + thigh + shin, 0.05, {-2.2, 0}});
    }
}

}  // namespace

void addDoll(Scene& scene, const Doll& doll) {
    const std::size_t firstBody = scene.bodies.size(), firstJoint = scene.joints.size();
    addUpright(scene, doll);
    if (doll.angle == 0) return;
    const Rot turned = Rot::fromAngle(doll.angle);
    const auto turn = [&](const Vec2& point) -> Vec2 { return doll.neck + turned * Vec2(point - doll.neck); };
    for (std::size_t i = firstBody; i < scene.bodies.size(); ++i) {
        BodyDef& body = scene.bodies[i].def;
        body.position = turn(body.position);
        body.angle = doll.angle;
    }
    for (std::size_t i = firstJoint; i < scene.joints.size(); ++i) {
        auto& joint = std::get<RevoluteJointDef>(scene.joints[i].def);
        joint.anchor = turn(joint.anchor);
    }
}

}  // namespace plumb::compare
