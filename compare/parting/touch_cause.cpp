// SPDX-License-Identifier: MIT
#include <compare/parting/touch_cause.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include <compare/engine/engine_settings.h>

namespace plumb::compare {
namespace {

constexpr double hitTime = 2.0 / 60;     // after this time a hit is over: an engine may spread it [s]
constexpr double aroundTime = 6.0 / 60;  // before and after: engines may see the same hit this far apart [s]
constexpr double leastBounce = 0.05;     // two coefficients of restitution that differ by more are reported [-]
constexpr double suddenSpeed = 0.05;     // a change of speed in a step is sudden if it exceeds gravity's by this [m/s]
constexpr double timesGravity = 1.5;     // the factor for gravity's change in that comparison [-]
constexpr double alikeAfterHit = 0.02;   // relative: two speeds after a hit that differ by less are the same [-]
constexpr double leastSpeed = 1e-3;      // the same, absolute [m/s]

/// How many steps a time takes; at least as many as at 60 Hz.
std::size_t stepsOf(double time, double dt) {
    return static_cast<std::size_t>(std::lround(time * std::max(60.0, 1 / dt)));
}

double bounceIn(double approach, double leaving) {
    return approach > 0 ? std::max(0.0, leaving / approach) : 0;
}

bool bounces(const SceneBody& body) {
    return std::ranges::any_of(body.def.shapes, [](const ShapeDef& shape) { return shape.material.restitution > 0; });
}

}  // namespace

TouchCause::TouchCause(const Parted& parted, const Share& share, const Touching& touching)
    : parted_(parted), share_(share), touching_(touching), a_(seenIn(parted.a)), b_(seenIn(parted.b)) {}

bool TouchCause::isSudden() const {
    const Difference what = kind();
    if (what != Difference::Hit) return what != Difference::Sliding && what != Difference::Pressing;
    const auto [a, b] = valuesOf(what);
    return std::abs(a - b) > alikeAfterHit * std::max(a, b) + leastSpeed;
}

Difference TouchCause::kind() const {
    const double window = static_cast<double>(stepsOf(hitTime, parted_.a.dt) + 1) * parted_.a.dt;
    const double sudden = timesGravity * parted_.scene.gravity.norm() * window + suddenSpeed;
    const bool isBraked = std::max(a_.before - a_.after, b_.before - b_.after) > sudden;
    if (share_.agent == Agent::Along) {
        const double most = std::max(std::abs(a_.along), std::abs(b_.along));
        if (most < sudden) return Difference::Sliding;
        const double across = std::max(std::abs(a_.across), std::abs(b_.across));
        return isBraked && across < most / 2 ? Difference::Snag : Difference::Hit;
    }
    if (std::max(std::abs(a_.across), std::abs(b_.across)) < sudden) return Difference::Pressing;
    if (isPassed(a_, b_) || isPassed(b_, a_)) return Difference::Passed;
    const auto [less, more] = std::minmax({std::abs(a_.across), std::abs(b_.across)});
    if (isBraked && less < more / 4) return Difference::Snag;
    const bool isHit = a_.approach > suddenSpeed && b_.approach > suddenSpeed;
    if (!isHit || !mayBounce()) return Difference::Hit;
    const double apart = std::abs(bounceIn(a_.approach, a_.leaving) - bounceIn(b_.approach, b_.leaving));
    if (apart > leastBounce) return Difference::Bounce;
    const double inAStep = timesGravity * parted_.scene.gravity.norm() * parted_.a.dt;
    const double alike = inAStep + alikeAfterHit * std::max(a_.after, b_.after) + leastSpeed;
    return std::abs(a_.after - b_.after) <= alike ? Difference::Moment : Difference::Hit;
}

/// A body that has no restitution may come back all the same: its joints throw it.
bool TouchCause::mayBounce() const {
    return std::ranges::any_of(std::array{&parted_.a, &parted_.b}, [&](const Observation* run) {
        const Scene scene = sceneFor(run->engine, parted_.scene);
        return bounces(scene.bodies[parted_.body]) || bounces(scene.bodies[share_.other]);
    });
}

void TouchCause::add(Parting& parting) const {
    const auto& bodies = parted_.scene.bodies;
    parting.quantity = kind();
    parting.at = bodies[parted_.body].name + ", " + bodies[share_.other].name;
    const bool isLasting = parting.quantity == Difference::Sliding || parting.quantity == Difference::Pressing;
    parting.when = static_cast<double>(isLasting ? parted_.tick : share_.tick) * parted_.a.dt;
    std::tie(parting.valueA, parting.valueB) = valuesOf(parting.quantity);
}

std::size_t TouchCause::lastTick() const {
    return std::min(parted_.a.states.size(), parted_.b.states.size()) - 1;
}

/// The step, near that of the share, in which the body is hit hardest in this run. The step may differ between engines.
std::size_t TouchCause::hitTickIn(const Observation& run) const {
    std::size_t hardest = share_.tick;
    double most = 0;
    const std::size_t around = stepsOf(aroundTime, run.dt);
    const std::size_t first = share_.tick - std::min(share_.tick, around),
                      end = std::min(share_.tick + around, lastTick());
    for (std::size_t tick = first; tick < end; ++tick) {
        const BodyState &now = run.states[tick][parted_.body], &next = run.states[tick + 1][parted_.body];
        const Vec2 change = next.velocity - now.velocity - parted_.scene.gravity * run.dt;
        const double hit = share_.agent == Agent::Across ? std::abs(change.dot(share_.normal)) : change.norm();
        if (hit <= most + leastSpeed) continue;
        most = hit;
        hardest = tick;
    }
    return hardest;
}

TouchCause::Seen TouchCause::seenIn(const Observation& run) const {
    const std::size_t hit = hitTickIn(run), steps = stepsOf(hitTime, run.dt), around = stepsOf(aroundTime, run.dt);
    const std::size_t before = hit - std::min(hit, steps / 2);
    const std::size_t after = std::min(hit + steps, lastTick());
    const auto& own = run.states;
    const Vec2 velocity = own[before][parted_.body].velocity, then = own[after][parted_.body].velocity;
    const auto relative = [&](std::size_t tick) {
        return (own[tick][parted_.body].velocity - own[tick][share_.other].velocity).dot(share_.normal);
    };
    const Vec2 fell = parted_.scene.gravity * (static_cast<double>(after - before) * run.dt);
    Seen seen{.approach = relative(before), .leaving = -relative(after)};
    seen.across = (then - velocity - fell).dot(share_.normal);
    seen.along = (then - velocity - fell).dot(perp(share_.normal));
    seen.before = velocity.norm();
    seen.after = then.norm();
    seen.from = centerIn(parted_, run, share_.tick - std::min(share_.tick, around));
    seen.to = centerIn(parted_, run, std::min(share_.tick + around, lastTick()));
    return seen;
}

/// True if the obstacle turns the second run back but not the first, and the first comes out on the other side or is
/// inside it.
bool TouchCause::isPassed(const Seen& through, const Seen& back) const {
    if (std::abs(through.across) > std::abs(back.across) / 2) return false;
    const Observation& run = &through == &a_ ? parted_.a : parted_.b;
    const std::vector<BodyState>& states = run.states[share_.tick];
    return touching_.isCrossed(share_.other, parted_.body, states, through.from, through.to) &&
           !touching_.isCrossed(share_.other, parted_.body, states, back.from, back.to);
}

std::pair<double, double> TouchCause::valuesOf(Difference quantity) const {
    switch (quantity) {
        case Difference::Bounce: return {bounceIn(a_.approach, a_.leaving), bounceIn(b_.approach, b_.leaving)};
        case Difference::Snag: return {a_.before - a_.after, b_.before - b_.after};
        case Difference::Moment:
        case Difference::Hit: return {a_.after, b_.after};
        case Difference::Passed: return {isPassed(a_, b_) ? 1 : 0, isPassed(b_, a_) ? 1 : 0};
        default: break;
    }
    const auto velocity = [&](const Observation& run) {
        const std::vector<BodyState>& now = run.states[parted_.tick];
        return quantity == Difference::Sliding ? Vec2(now[parted_.body].velocity - now[share_.other].velocity)
                                               : now[parted_.body].velocity;
    };
    const Vec2 a = velocity(parted_.a), b = velocity(parted_.b);
    if (quantity != Difference::Sliding) return {a.norm(), b.norm()};
    // The faster one's direction counts as forward.
    const Vec2 along = perp(share_.normal);
    const double alongA = a.dot(along), alongB = b.dot(along);
    const double sign = std::abs(alongA) >= std::abs(alongB) ? alongA : alongB;
    return {std::copysign(1.0, sign) * alongA, std::copysign(1.0, sign) * alongB};
}

}  // namespace plumb::compare
