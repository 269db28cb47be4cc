// SPDX-License-Identifier: MIT
#include <compare/scene/random/machines.h>

namespace plumb::compare {
namespace {

/// A limb from one point down to another. It is on a hinge at the first point, and may turn this far either way.
struct DollLimb {
    std::string name, from;
    Vec2 top, end;
    double radius;
    Limit limit;
};

/// Makes a doll of 1.9 m times a factor, with its neck at the origin.
class DollBuilder {
public:
    DollBuilder(double size, double density, int group) : size_(size), density_(density), group_(group) {}

    void addPart(const std::string& name, const Vec2& top, const Vec2& end, double radius) {
        const Vec2 middle = size_ * (top + end) / 2, half = size_ * (end - top) / 2;
        ShapeDef shape = capsule(-half, half, size_ * radius, {.density = density_, .friction = 0.4});
        shape.filter.group = group_;
        item.bodies.push_back({name, {.position = middle, .shapes = {shape}}});
    }
    void addLimb(const DollLimb& limb) {
        addPart(limb.name, limb.top, limb.end, limb.radius);
        const RevoluteJointDef hinge{.anchor = size_ * limb.top, .limit = limb.limit};
        item.joints.push_back({limb.name + "_joint", limb.from, limb.name, hinge});
    }

    Item item{};

private:
    double size_, density_;
    int group_;
};

}  // namespace

Item drawDoll(Draw& draw, double density, int group) {
    const double size = draw.uniform(0.6, 1.5);
    DollBuilder doll(size, density, group);
    const Vec2 up(0, 0.55);  // the neck; the middle of the doll is at the origin
    const Vec2 hip = up - Vec2(0, 0.6), shoulder = up - Vec2(0, 0.05);
    const Vec2 upper(0, -0.3), lower(0, -0.28), thigh(0, -0.4), shin(0, -0.35);
    doll.addPart("torso", up, up - Vec2(0, 0.55), 0.13);
    doll.addLimb({"head", "torso", up + Vec2(0, 0.05), up + Vec2(0, 0.25), 0.11, {-0.5, 0.5}});
    for (const std::string side : {"left_", "right_"}) {
        doll.addLimb({side + "arm", "torso", shoulder, shoulder + upper, 0.05, {-2.5, 2.5}});
        doll.addLimb({side + "hand", side + "arm", shoulder + upper, shoulder + upper + lower, 0.04, {0, 2.4}});
        doll.addLimb({side + "thigh", "torso", hip, hip + thigh, 0.07, {-0.5, 1.8}});
        doll.addLimb({side + "shin", side + "thigh", hip + thigh, hip + thigh + shin, 0.05, {-2.2, 0}});
    }
    doll.item.half = Vec2::Constant(0.95 * size);
    return turned(doll.item, draw.uniform(-fullTurn / 2, fullTurn / 2));
}

}  // namespace plumb::compare
