// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/quarantine.h>

#include <algorithm>
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

/// What has begun in this very step and ends in it, from an end on, has not been: ends are told before begins.
void unsayTouches(WorldState& world, std::size_t from) {
    const auto isUnsaid = [&world](const ContactEnd& end) {
        const auto begin = std::find_if(world.begins.begin(), world.begins.end(), [&end](const ContactBegin& b) {
            return b.shapeA == end.shapeA && b.shapeB == end.shapeB;
        });
        if (begin == world.begins.end()) return false;
        world.begins.erase(begin);
        return true;
    };
    const auto first = world.ends.begin() + static_cast<std::ptrdiff_t>(from);
    world.ends.erase(std::remove_if(first, world.ends.end(), isUnsaid), world.ends.end());
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
        if (world.bodies.record[body].enabled) {
            const std::size_t told = world.ends.size();
            hideShapes(world, body);
            unsayTouches(world, told);
        }
        world.bodies.putToSleep(body);
        for (const JointIndex joint : world.bodies.record[body].joints) {
            world.joints.loads[joint] = {};  // what it bore was no number
            world.jointsChanged = true;
        }
        world.bodies.motion[body].velocity.setZero();
        world.bodies.motion[body].angularVelocity = 0;
        world.bodies.rest(body);
        world.quarantines.push_back({world.idOf(body)});
    }
}

}  // namespace plumb
