// SPDX-License-Identifier: MIT
#include <compare/scene/builtin/links.h>
#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {
namespace {

const Vec2 neck(0.3, 4.4);  // where the doll stands: its toes are 1.4 m below, 0.2 m over the top step

/// A limb from one point down to another, on a hinge at the first, free to turn so far either way.
struct Limb {
    std::string name;
    std::string from;
    Vec2 top, end;
    double radius;
    Limit limit;
};

void addPart(Scene& scene, const std::string& name, const Vec2& top, const Vec2& end, double radius) {
    const Vec2 middle = (top + end) / 2;
    ShapeDef shape = capsule(top - middle, end - middle, radius, {.density = 500, .friction = 0.4});
    shape.filter.group = -1;  // the parts of a doll pass each other
    scene.bodies.push_back({name, {.position = middle, .velocity = {2, 0}, .shapes = {shape}}});
}

void addLimb(Scene& scene, const Limb& limb) {
    addPart(scene, limb.name, limb.top, limb.end, limb.radius);
    auto& joint = hinge(scene, limb.name + "_joint", limb.from, limb.name, limb.top);
    std::get<RevoluteJointDef>(joint.def).limit = limb.limit;
    scene.probes.push_back(
        {.name = limb.name + "_limit", .quantity = LimitProbe{joint.name}, .expected = 0, .unit = "rad"});
    scene.checks.push_back(invariant("probe." + limb.name + "_limit", 0.05, "3 degrees, at a fall of 3 m"));
}

ShapeDef stairs() {
    constexpr int steps = 8;
    std::vector<Vec2> points{{10, 0}};
    for (int i = 0; i < steps; ++i) {
        const double x = 4 - 0.5 * i, y = 0.35 * i;
        points.push_back({x, y});
        points.push_back({x, y + 0.35});
    }
    points.push_back({-4, 0.35 * steps});
    return chain(points, {.friction = 0.4});  // from right to left: solid from above
}

}  // namespace

Scene ragdoll() {
    Scene scene{
        .name = "ragdoll",
        .question = "Does a doll that is pushed down the stairs hold together, bend no joint too far, and lie still?",
        .duration = 10,
        .bodies = {{"stairs", {.type = BodyType::Static, .shapes = {stairs()}}}}};
    addPart(scene, "torso", neck, neck - Vec2(0, 0.55), 0.13);
    const Vec2 hip = neck - Vec2(0, 0.6), shoulder = neck - Vec2(0, 0.05);
    const Vec2 upper(0, -0.3), lower(0, -0.28), thigh(0, -0.4), shin(0, -0.35);
    addLimb(scene, {"head", "torso", neck + Vec2(0, 0.05), neck + Vec2(0, 0.25), 0.11, {-0.5, 0.5}});
    for (const std::string side : {"left_", "right_"}) {
        addLimb(scene, {side + "arm", "torso", shoulder, shoulder + upper, 0.05, {-2.5, 2.5}});
        addLimb(scene, {side + "hand", side + "arm", shoulder + upper, shoulder + upper + lower, 0.04, {0, 2.4}});
        addLimb(scene, {side + "thigh", "torso", hip, hip + thigh, 0.07, {-0.5, 1.8}});
        addLimb(scene, {side + "shin", side + "thigh", hip + thigh, hip + thigh + shin, 0.05, {-2.2, 0}});
    }
    scene.checks.push_back(invariant("joint_error_max", 4e-2,
                                     "what a limb comes in a sub-step at 8 m/s, 3.3 cm, when the floor stops it"));
    scene.checks.push_back(invariant(
        "penetration_max", 2e-2, "less than the 3.3 cm that a limb moves in a sub-step, while its joints press on it"));
    scene.checks.push_back(invariant("settle_time", 9, "the stairs are only 2.8 m high; then friction stops the body"));
    return scene;
}

}  // namespace plumb::compare
