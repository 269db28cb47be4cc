// SPDX-License-Identifier: MIT
#include <plumb/steering/pursue.h>

#include <algorithm>
#include <cmath>

#include <plumb/math/check.h>
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

}  // namespace

Vec2 pursue(const Agent& agent, const Seen& quarry, double mostAhead) {
    requireNotNegative(mostAhead, "pursue: mostAhead");
    const Vec2 d = quarry.position - agent.position;
    return seek(agent, quarry.position + meetingTime(d, quarry.velocity, agent.maxSpeed, mostAhead) * quarry.velocity);
}

Vec2 evade(const Agent& agent, const Seen& pursuer, double mostAhead) {
    requireNotNegative(mostAhead, "evade: mostAhead");
    const double distance = (pursuer.position - agent.position).norm(), speed = pursuer.velocity.norm();
    const double time = distance < mostAhead * speed ? distance / speed : mostAhead;
    return flee(agent, pursuer.position + time * pursuer.velocity);
}

}  // namespace plumb
