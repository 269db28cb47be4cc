// SPDX-License-Identifier: MIT
#include <plumb/steering/wander.h>

#include <cmath>
#include <numbers>

#include <plumb/math/check.h>
#include <plumb/math/rot.h>
#include <plumb/steering/seek.h>

namespace plumb {

WanderStep wander(const Agent& agent, const WanderState& state, double dt, const WanderSettings& settings) {
    validate(agent);
    requireFinite(state.angle, "WanderState", ".angle");
    requirePositive(settings.radius, "WanderSettings", ".radius");
    requireNotNegative(settings.jitter, "WanderSettings", ".jitter");
    requireFinite(settings.ahead, "WanderSettings", ".ahead");
    if (!(settings.ahead > settings.radius))
        refuse("WanderSettings.ahead", toText(settings.ahead) + " is not more than the radius");
    requireNotNegative(dt, "wander: dt");

    WanderStep step{{0, 0}, state};
    // A uniform distribution within +- sqrt(3) has a mean square of 1.
    const double turn = settings.jitter * std::sqrt(dt) * step.state.random.uniform(-1, 1) * std::numbers::sqrt3;
    step.state.angle = state.angle + turn;
    requireFinite(step.state.angle, "WanderState", ".angle + turn");
    const Vec2 heading = headingOf(agent);
    const Rot facing{heading.x(), heading.y()};
    const Vec2 target =
        settings.ahead * heading + settings.radius * (facing * (Rot::fromAngle(step.state.angle) * Vec2(1, 0)));
    step.acceleration = seek(agent, agent.position + target);
    return step;
}

}  // namespace plumb
