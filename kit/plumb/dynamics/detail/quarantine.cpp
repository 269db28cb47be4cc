// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/quarantine.h>

#include <cmath>

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

void markUnsound(WorldState& world) {
    for (const BodyIndex body : world.bodies.awake) {
        const Acceleration a = accelerationOf(world.bodies.record[body], world.def.gravity);
        if (!isSound(world.bodies.motion[body]) || !within(a.linear) || !within(a.angular))
            world.bodies.record[body].quarantined = true;
    }
}

void quarantine(WorldState& world) {
    std::vector<BodyIndex> leaving;
    for (const BodyIndex body : world.bodies.awake)
        if (world.bodies.record[body].quarantined) leaving.push_back(body);
    for (const BodyIndex body : leaving) {
        wakeNeighbours(world, body);
        removeShapes(world, body);
        world.bodies.putToSleep(body);
        BodyRecord& record = world.bodies.record[body];
        record.type = BodyType::Static;
        record.mass = record.inertia = record.inverseMass = record.inverseInertia = 0;
        world.bodies.motion[body].velocity.setZero();
        world.bodies.motion[body].angularVelocity = 0;
        world.quarantines.push_back({world.idOf(body)});
    }
}

}  // namespace plumb
