// SPDX-License-Identifier: MIT
#include <compare/check/aimed.h>

#include <cmath>
#include <numbers>
#include <vector>

#include <compare/scene/joint_geometry.h>
#include <plumb/ballistics/fixed_speed.h>
#include <plumb/ballistics/least_speed.h>
#include <plumb/ballistics/linear_drag_aim.h>
#include <plumb/ballistics/moving_target.h>

namespace plumb::compare {
namespace {

using Part = AimReading::Part;

std::vector<Shot> shotsOf(const BodyDef& body, const Vec2& gravity, const BodyDef& target) {
    const Vec2 away = target.position - body.position;
    const double speed = body.velocity.norm();
    const bool stands = target.velocity == Vec2(0, 0);
    if (body.linearDamping > 0 && !stands) return {};
    if (body.linearDamping > 0)
        return aimThroughLinearDrag(
            {.target = away, .speed = speed, .drag = {.rate = body.linearDamping, .gravity = gravity}});
    if (!stands)
        return aimAtMoving({.target = away, .targetVelocity = target.velocity, .speed = speed, .gravity = gravity});
    return aim({.target = away, .speed = speed, .gravity = gravity});
}

}  // namespace

std::optional<double> aimed(const Scene& scene, const AimReading& wanted) {
    const BodyDef& body = scene.bodies[bodyIndex(scene, wanted.body)].def;
    const BodyDef& target = scene.bodies[bodyIndex(scene, wanted.target)].def;
    const Vec2 gravity = body.gravityScale * scene.gravity;
    if (wanted.part == Part::LeastSpeed) {
        const std::optional<Shot> slowest = aimSlowest({.target = target.position - body.position, .gravity = gravity});
        if (!slowest || body.linearDamping > 0 || target.velocity != Vec2(0, 0)) return {};
        return slowest->velocity.norm();
    }
    const std::vector<Shot> shots = shotsOf(body, gravity, target);
    if (shots.empty()) return {};
    const bool isLow = wanted.part == Part::LowAngle || wanted.part == Part::LowTime;
    const Shot& shot = isLow ? shots.front() : shots.back();
    if (wanted.part == Part::LowTime || wanted.part == Part::HighTime) return shot.time;
    return std::atan2(shot.velocity.y(), shot.velocity.x()) * 180 / std::numbers::pi;
}

std::string unitOf(const AimReading& wanted) {
    if (wanted.part == Part::LeastSpeed) return "m/s";
    return wanted.part == Part::LowTime || wanted.part == Part::HighTime ? "s" : "deg";
}

}  // namespace plumb::compare
