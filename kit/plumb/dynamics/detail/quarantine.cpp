// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/quarantine.h>

#include <cmath>
#include <utility>

#include <plumb/dynamics/detail/body_shapes.h>
#include <plumb/dynamics/detail/islands.h>

namespace plumb {

namespace {

constexpr double largest = 1e15;

bool within(double value) {
    return std::fabs(value) < largest;  // false for nan
}

bool within(const Vec2& value) {
    return within(value.x()) && within(value.y());
}

}  // namespace

bool isSound(const BodyMotion& m) {
    return within(m.center) && within(m.velocity) && within(m.angle) && within(m.angularVelocity);
}

bool isSound(const Acceleration& a) {
    return within(a.linear) && within(a.angular);
}

void quarantineLater(WorldState& world, BodyIndex body) {
    if (world.bodies.record[body].quarantined) return;
    world.bodies.record[body].quarantined = true;
    world.unsound.push_back(body);
}

void quarantine(WorldState& world) {
    const std::vector<BodyIndex> leaving = std::move(world.unsound);
    world.unsound.clear();
    for (const BodyIndex body : leaving) {
        wakeNeighbours(world, body);
        if (world.bodies.record[body].enabled) hideShapes(world, body);
        world.bodies.putToSleep(body);
        world.bodies.motion[body].velocity.setZero();
        world.bodies.motion[body].angularVelocity = 0;
        world.bodies.rest(body);
        world.quarantines.push_back({world.idOf(body)});
    }
}

}  // namespace plumb
