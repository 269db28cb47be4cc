// SPDX-License-Identifier: MIT
#include <numbers>
#include <string>

#include <compare/scene/bench/parts.h>
#include <compare/scene/bench/scenes.h>

namespace plumb::compare {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double frictionTorque = 0.05;                     // of a joint of strength 1 [N m]
constexpr double springRate = 5, springDampingRatio = 0.5;  // of the masses that a joint turns [Hz], [-]

/// A bone, and the hinge by which it hangs on another. Heights are measured from the soles; a bone is an upright
/// capsule.
struct Bone {
    const char* name;
    int parent;                   // its place in the list
    double height, lower, upper;  // of its middle; of its ends, from there [m]
    double radius;                // [m]
    double damping;               // [1/s]
    double hinge;                 // height [m]
    double strength;              // of the hinge's friction [-]
    double least, most;           // of the hinge's angle [rad]
    double rest;                  // its angle without load [rad]
    bool foot;
};

constexpr Bone hip{"hip", -1, 0.95, -0.02, 0.02, 0.095, 0, 0, 0, 0, 0, 0, false};
constexpr Bone torso{"torso", 0, 1.2, -0.135, 0.135, 0.09, 0, 1, 0.5, -0.25 * pi, 0, 0, false};
constexpr Bone head{"head", 1, 1.475, -0.038, 0.039, 0.075, 0.1, 1.4, 0.25, -0.3 * pi, 0.1 * pi, 0, false};
constexpr Bone thigh(const char* name) {
    return {name, 0, 0.775, -0.125, 0.125, 0.06, 0, 0.9, 1, -0.05 * pi, 0.4 * pi, 0, false};
}
constexpr Bone shin(const char* name, int thigh) {
    return {name, thigh, 0.475, -0.155, 0.125, 0.045, 0, 0.625, 0.5, -0.5 * pi, -0.02 * pi, 0, true};
}
constexpr Bone upperArm(const char* name) {
    return {name, 1, 1.225, -0.125, 0.125, 0.035, 0, 1.35, 0.5, -0.1 * pi, 0.8 * pi, 0, false};
}
/// At rest it is bent by a quarter of pi, measured from the zero of its limits.
constexpr Bone lowerArm(const char* name, int arm) {
    return {name, arm, 0.975, -0.125, 0.125, 0.03, 0.1, 1.1, 0.1, 0.05 * pi, 0.55 * pi, 0.25 * pi, false};
}
constexpr Bone bones[] = {hip,
                          torso,
                          head,
                          thigh("left_thigh"),
                          shin("left_shin", 3),
                          thigh("right_thigh"),
                          shin("right_shin", 5),
                          upperArm("left_arm"),
                          lowerArm("left_hand", 7),
                          upperArm("right_arm"),
                          lowerArm("right_hand", 9)};

/// When a doll appears, and after how long it is removed and made anew [s].
struct Turn {
    double appears, renewed;
};

/// The foot passes through other dolls, and has less friction.
std::vector<ShapeDef> shapesOf(const Bone& bone, int group) {
    const Filter filter{.category = 2, .mask = 3, .group = -group};
    ShapeDef limb = capsule({0, bone.lower}, {0, bone.upper}, bone.radius, {.friction = 0.2});
    limb.filter = filter;
    if (!bone.foot) return {limb};
    const std::vector<Vec2> sole{{-0.03, -0.185}, {0.11, -0.185}, {0.11, -0.16}, {-0.03, -0.14}};
    ShapeDef foot = roundedPolygon(sole, 0.015, {.friction = 0.05});
    foot.filter = {.category = 2, .mask = 1, .group = -group};
    return {limb, foot};
}

/// A doll of eleven bones that stands at a place. Its hinges have friction and springs.
void addDoll(Scene& scene, const std::string& name, const Vec2& soles, int group, const Turn& turn) {
    const std::size_t first = scene.bodies.size();
    for (const Bone& bone : bones) {
        SceneBody body{
            name + bone.name,
            {.position = soles + Vec2(0, bone.height), .linearDamping = bone.damping, .shapes = shapesOf(bone, group)}};
        body.appears = turn.appears;
        body.renewed = turn.renewed;
        scene.bodies.push_back(body);
        if (bone.parent < 0) continue;
        const SceneBody& parent = scene.bodies[first + static_cast<std::size_t>(bone.parent)];
        const double turning = 1 / (1 / massOf(parent.def).inertia + 1 / massOf(body.def).inertia);
        scene.joints.push_back({body.name, parent.name, body.name,
                                RevoluteJointDef{.anchor = soles + Vec2(0, bone.hinge),
                                                 .limit = Limit{bone.least, bone.most},
                                                 .spring = springOf(springRate, springDampingRatio, turning),
                                                 .restAngle = bone.rest,
                                                 .maxMotorTorque = bone.strength * frictionTorque}});
    }
}

/// Floors made of blocks of half a metre, one above the other.
std::vector<ShapeDef> floors(int count, double apart, double halfWidth) {
    constexpr double block = 0.5;
    std::vector<ShapeDef> shapes;
    for (int floor = 0; floor < count; ++floor)
        for (int i = 0; i <= 500; ++i)
            shapes.push_back({boxPolygon({block / 2, block / 2}, {i * block - halfWidth, floor * apart})});
    return shapes;
}

}  // namespace

Scene rain() {
    constexpr int rows = 5, columns = 40, groupSize = 5, stepsApart = 8;
    constexpr double halfWidth = 125, apart = 45, pitch = 2 * halfWidth / columns;  // [m]
    Scene scene =
        benchScene("rain", "What does a step take when 1,000 dolls of ten joints rain, and rain again?", 1000);
    scene.bodies.push_back(fixedBody("ground", floors(rows, apart, halfWidth)));
    const double wait = stepsApart * scene.dt;
    for (int column = 0; column < columns; ++column)
        for (int row = 0; row < rows; ++row)
            for (int i = 0; i < groupSize; ++i) {
                const std::string name = "doll_" + std::to_string((row * columns + column) * groupSize + i + 1) + "_";
                const Vec2 soles(-halfWidth + pitch * (column + 0.5) + 0.5 * i, 40 + apart * row);
                addDoll(scene, name, soles, i + 1, {column * wait, columns * wait});
            }
    return scene;
}

}  // namespace plumb::compare
