// SPDX-License-Identifier: MIT
#include <compare/scene/random/machines.h>

#include <algorithm>

#include <plumb/math/trig.h>

namespace plumb::compare {
namespace {

SceneJoint hingeAt(const std::string& name, const std::string& a, const std::string& b, const Vec2& anchor) {
    return {name, a, b, RevoluteJointDef{.anchor = anchor}};
}

std::string linkName(int i) {
    return "link_" + std::to_string(i);
}

std::string hingeName(int i) {
    return "hinge_" + std::to_string(i);
}

}  // namespace

Item drawBridge(Draw& draw, int planks, double density, int group) {
    const double length = draw.uniform(0.3, 0.8), thickness = draw.uniform(0.04, 0.1);  // half of it [m]
    const double halfSpan = planks * length / 2, sag = halfSpan * draw.uniform(0.1, 0.3);
    const auto hingeAtPlank = [&](int i) {
        const double x = 2.0 * i / planks - 1;
        return Vec2(halfSpan * x, sag * (x * x - 0.5));
    };
    Item item{.half = {halfSpan + 0.2, sag + 0.3}};  // room for swaying
    for (int i = 0; i < planks; ++i) {
        const Vec2 from = hingeAtPlank(i), along = hingeAtPlank(i + 1) - from;
        ShapeDef plank = box({along.norm() / 2, thickness}, {.density = density});
        plank.filter.group = group;
        const double angle = arcTangent(along.y(), along.x());
        item.bodies.push_back({linkName(i), {.position = from + along / 2, .angle = angle, .shapes = {plank}}});
        item.joints.push_back(hingeAt(hingeName(i), i == 0 ? worldName : linkName(i - 1), linkName(i), from));
    }
    const Vec2 end = hingeAtPlank(planks);
    item.joints.push_back(hingeAt(hingeName(planks), worldName, linkName(planks - 1), end));
    return item;
}

Item drawRope(Draw& draw, int links, double density, int group) {
    const bool hangs = draw.chance(0.5);
    const double half = draw.uniform(0.12, 0.3), radius = half * draw.uniform(0.2, 0.5);  // of a link [m]
    const double angle = hangs ? draw.uniform(-1, 1) - fullTurn / 4 : draw.uniform(-fullTurn / 2, fullTurn / 2);
    const double start = -links * half;
    Item item{.half = Vec2::Constant(links * half + radius)};
    for (int i = 0; i < links; ++i) {
        const Vec2 from(start + 2 * half * i, 0);
        ShapeDef link = capsule({-half, 0}, {half, 0}, radius, {.density = density});
        link.filter.group = group;
        item.bodies.push_back({linkName(i), {.position = from + Vec2(half, 0), .shapes = {link}}});
        if (i > 0) item.joints.push_back(hingeAt(hingeName(i), linkName(i - 1), linkName(i), from));
    }
    if (hangs) item.joints.push_back(hingeAt(hingeName(0), worldName, linkName(0), {start, 0}));
    return turned(item, angle);
}

Item drawCar(Draw& draw, double density) {
    const double size = draw.uniform(0.5, 1.5), speed = draw.eitherWay(3, 15);
    const double wheel = size * draw.uniform(0.3, 0.45), mass = density * 1.2 * size * size;
    Item item{.bodies = {{"chassis", {.position = {0, 0.2 * size}, .shapes = {}}}}, .half = {1.3 * size, 0.9 * size}};
    item.bodies[0].def.shapes = {box(size * Vec2(1.2, 0.25), {.density = density})};
    for (const double side : {-1.0, 1.0}) {
        const Vec2 hub = size * Vec2(0.8 * side, -0.3);
        const std::string name = side < 0 ? "rear" : "front";
        item.bodies.push_back(
            {name, {.position = hub, .shapes = {circle(wheel, {.density = density, .friction = 0.9})}}});
        item.joints.push_back({name + "_suspension", "chassis", name,
                               WheelJointDef{.anchor = hub,
                                             .axis = {0, 1},
                                             .limit = Limit{-0.25 * size, 0.25 * size},
                                             .spring = springOf(2, 0.7, mass / 2),
                                             .motorSpeed = -speed / wheel,
                                             .maxMotorTorque = 3 * mass * wheel}});
    }
    return item;
}

std::vector<Item> drawMachines(Draw& draw, int bodies, double density) {
    std::vector<Item> machines;
    std::vector<Item> bridges;
    int left = bodies, group = 0;
    while (left >= 10 || (left >= 3 && draw.chance(0.5))) {
        --group;
        const int kind = draw.integer(0, 3), length = std::min(left, draw.integer(5, 30));
        if (kind == 0 && left >= 10)
            machines.push_back(drawDoll(draw, density, group));
        else if (kind == 1 && length >= 5)
            bridges.push_back(drawBridge(draw, length, density, group));
        else if (kind == 2 && length >= 5)
            machines.push_back(drawRope(draw, length, density, group));
        else
            machines.push_back(drawCar(draw, density));
        left -=
            static_cast<int>(kind == 1 && length >= 5 ? bridges.back().bodies.size() : machines.back().bodies.size());
    }
    bridges.insert(bridges.end(), machines.begin(), machines.end());
    return bridges;
}

}  // namespace plumb::compare
