// SPDX-License-Identifier: MIT
#include <plumb/steering/pursue.h>

#include <algorithm>
#include <cmath>

#include <plumb/math/check.h>
#include <plumb/steering/detail/vectors.h>
#include <plumb/steering/seek.h>

namespace plumb {
namespace {

/// When one at that speed meets what is at d and moves at w; most where it does not within that time.
double meetingTime(const Vec2& d, const Vec2& w, double speed, double most) {
    if (d.isZero(0)) return 0;
    const double along = d.dot(w);
    const double discriminant = along * along + (speed * speed - w.squaredNorm()) * d.squaredNorm();
    if (!(discriminant >= 0)) return most;
    const double divisor = std::sqrt(discriminant) - along;
    return divisor > 0 ? std::min(most, d.squaredNorm() / divisor) : most;
}

/// Straight out of the way of what moves at w, for one that stands at back from it.
Vec2 aside(const Vec2& w, const Vec2& back) {
    const Vec2 left = perp(detail::directionOf(w));
    return cross(w, back) >= 0 ? left : Vec2(-left);
}

}  // namespace

void validate(const Seen& seen, std::string_view field) {
    requireFinite(seen.position, field, ".position");
    requireFinite(seen.velocity, field, ".velocity");
}

Vec2 pursue(const Agent& agent, const Seen& quarry, double mostAhead) {
    validate(agent);
    validate(quarry);
    requireNotNegative(mostAhead, "pursue: mostAhead");
    const Vec2 d = quarry.position - agent.position;
    return seek(agent, quarry.position + meetingTime(d, quarry.velocity, agent.maxSpeed, mostAhead) * quarry.velocity);
}

Vec2 evade(const Agent& agent, const Seen& pursuer, double mostAhead) {
    validate(agent);
    validate(pursuer);
    requireNotNegative(mostAhead, "evade: mostAhead");
    const Vec2 back = agent.position - pursuer.position;
    const double distance = detail::lengthOf(back), speed = detail::lengthOf(pursuer.velocity);
    if (speed > agent.maxSpeed && pursuer.velocity.dot(back) > 0 && distance < mostAhead * speed)
        return steerTo(agent, agent.maxSpeed * aside(pursuer.velocity, back));
    const double time = std::min(mostAhead, distance / (agent.maxSpeed + speed));
    return flee(agent, pursuer.position + time * pursuer.velocity);
}

}  // namespace plumb
