// SPDX-License-Identifier: MIT
#include <compare/check/samples.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace plumb::compare {
namespace {

/// A change of velocity counts as an impact if it is so many times as large as what forces explain [-].
constexpr double leastJump = 5;
/// The two flights meet if they pass each other at most at this share of the way that the jump makes in a step [-].
constexpr double farthestMiss = 0.1;
/// A smaller share of the speed is rounding [-].
constexpr double leastShare = 1e-9;

/// One step of one body, with the accelerations of the steps beside it.
struct StepOfBody {
    const BodyState& start;
    const BodyState& end;
    double length;  ///< [s]
    Vec2 before, after;

    Vec2 placeBefore(double time) const { return start.position + time * start.velocity + 0.5 * time * time * before; }
    Vec2 placeAfter(double time) const {
        const double left = length - time;
        return end.position - left * end.velocity + 0.5 * left * left * after;
    }
    Vec2 velocityBefore(double time) const { return start.velocity + time * before; }
    Vec2 velocityAfter(double time) const { return end.velocity - (length - time) * after; }
};

/// The time in the step at which the velocity jumps [s]; none if it does not.
std::optional<double> jumpIn(const StepOfBody& step) {
    const Vec2 jump = step.velocityAfter(0.5 * step.length) - step.velocityBefore(0.5 * step.length);
    const double size = jump.norm(), forces = step.length * (step.after - step.before).norm();
    const double speed = std::max(step.start.velocity.norm(), step.end.velocity.norm());
    if (!(size > leastJump * forces && size > leastShare * speed)) return {};
    const Vec2 along = jump / size;
    double time = 0.5 * step.length;
    for (int i = 0; i < 8; ++i) {  // Newton's method; the gap is nearly linear in time
        const double gap = (step.placeBefore(time) - step.placeAfter(time)).dot(along);
        const double closing = (step.velocityBefore(time) - step.velocityAfter(time)).dot(along);
        if (closing == 0) return {};
        time = std::clamp(time - gap / closing, 0.0, step.length);
    }
    const double miss = (step.placeBefore(time) - step.placeAfter(time)).norm();
    if (miss > farthestMiss * size * step.length) return {};
    return time;
}

}  // namespace

std::vector<Sample> samplesOf(const Scene& scene, const Observation& run, std::size_t body) {
    std::vector<Sample> samples;
    const bool mayHit = scene.bodies[body].def.type == BodyType::Dynamic;
    const std::size_t count = run.states.size();
    const auto at = [&](std::size_t tick) -> const BodyState& { return run.states[tick][body]; };
    // Of the step after a tick.
    const auto acceleration = [&](std::size_t tick) -> Vec2 {
        return (at(tick + 1).velocity - at(tick).velocity) / run.dt;
    };
    for (std::size_t i = 0; i < count; ++i) {
        samples.push_back({static_cast<double>(i) * run.dt, at(i)});
        if (!mayHit || i == 0 || i + 2 >= count) continue;  // of the first and the last step nothing stands beside
        const StepOfBody step{.start = at(i),
                              .end = at(i + 1),
                              .length = run.dt,
                              .before = acceleration(i - 1),
                              .after = acceleration(i + 1)};
        const std::optional<double> time = jumpIn(step);
        if (!time) continue;
        BodyState hit = at(i);
        hit.position = 0.5 * (step.placeBefore(*time) + step.placeAfter(*time));
        hit.angle += *time * hit.angularVelocity;
        hit.velocity = step.velocityBefore(*time);
        samples.push_back({samples.back().time + *time, hit});
        hit.velocity = step.velocityAfter(*time);
        hit.angularVelocity = at(i + 1).angularVelocity;
        samples.push_back({samples.back().time, hit});
    }
    return samples;
}

}  // namespace plumb::compare
