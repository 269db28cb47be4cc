// SPDX-License-Identifier: MIT
#include <plumb/movers/detail/platform_tick.h>

#include <algorithm>
#include <cmath>

namespace plumb::detail {

namespace {

/// Speeds as displacements per tick, and accelerations as changes of those per tick; both rounded to multiples of the
/// grain, if there is one.
class TickUnits {
public:
    TickUnits(double grain, double dt) : grain_(grain), dt_(dt) {}
    double speed(double metresPerSecond) const { return whole(metresPerSecond * dt_); }
    double acceleration(double a) const { return whole(a * dt_ * dt_); }
    double perSecond(double motion) const { return motion / dt_; }

private:
    double whole(double motion) const { return grain_ > 0 ? std::round(motion / grain_) * grain_ : motion; }
    double grain_, dt_;
};

double toward(double from, double to, double most) {
    return from < to ? std::min(from + most, to) : std::max(from - most, to);
}

/// Motion in a part of a tick, 0 to 1.
struct MotionPart {
    double shift = 0, speed = 0, left = 0;  ///< left: of the tick
};

/// Constant acceleration up to a speed, then constant speed.
MotionPart approach(double speed, double to, double acceleration, double time) {
    const double away = std::fabs(to - speed);
    if (away > acceleration * time) {
        const double after = toward(speed, to, acceleration * time);
        return {0.5 * (speed + after) * time, after, 0};
    }
    const double took = acceleration > 0 ? away / acceleration : 0;
    return {0.5 * (speed + to) * took, to, time - took};
}

double accelerationOf(const HorizontalMotion& horizontal, const HorizontalTick& tick) {
    const bool fast =
        !tick.runs && horizontal.fastSpeed && std::fabs(tick.speed) >= *horizontal.fastSpeed * (1 - 1e-12);
    const double own = fast        ? horizontal.fastAcceleration
                       : tick.runs ? horizontal.runAcceleration
                                   : horizontal.walkAcceleration;
    const double shared = tick.onFloor ? own : own * horizontal.airShare;
    if (tick.move == 0) return (tick.onFloor ? horizontal.friction : horizontal.airFriction).value_or(shared);
    return shared;
}

double truncatedTo(double grain, double motion) {
    return grain > 0 ? std::trunc(motion / grain) * grain : motion;
}

}  // namespace

TickMotion horizontalTick(const PlatformProfile& profile, const HorizontalTick& tick, double dt) {
    const HorizontalMotion& horizontal = profile.horizontal;
    const TickUnits ticks(profile.grain, dt);
    double speed = ticks.speed(tick.speed);
    const double own = tick.runs ? horizontal.runSpeed : horizontal.walkSpeed;
    const double target = ticks.speed(tick.move * std::min(own, tick.most.value_or(own)));
    double gain = ticks.acceleration(accelerationOf(horizontal, tick));
    const bool turns = tick.move * speed < 0;
    const double turnGain = turns ? gain * horizontal.turnFactor : gain;
    if (turns && tick.onFloor && std::fabs(speed) < ticks.speed(horizontal.turnStopSpeed)) speed = 0;
    const bool over = tick.move * target > 0 && tick.move * speed > tick.move * target;
    if (over && horizontal.overSpeed == OverSpeed::Cut) speed = target;
    if (over && horizontal.overSpeed == OverSpeed::Slow)
        gain = ticks.acceleration(
            (tick.onFloor ? horizontal.friction : horizontal.airFriction).value_or(gain / (dt * dt)));
    if (horizontal.order == TickOrder::Exact) {
        MotionPart motion{0, speed, 1};
        if (turns) motion = approach(speed, 0, turnGain, 1);
        const MotionPart rest = approach(motion.speed, target, gain, motion.left);
        return {motion.shift + rest.shift + rest.speed * rest.left, ticks.perSecond(rest.speed)};
    }
    const double after = toward(speed, target, turns ? turnGain : gain);
    const double shift = horizontal.order == TickOrder::PositionFirst ? speed : after;
    return {truncatedTo(horizontal.moveGrain, shift), ticks.perSecond(after)};
}

namespace {

double gravityOf(const VerticalMotion& vertical, const VerticalTick& tick, double speed, bool downward) {
    const double own = downward ? tick.band.fallGravity : tick.rises ? tick.band.riseGravity : tick.band.releaseGravity;
    const bool hangs = tick.held && std::fabs(speed) < vertical.hangSpeed;
    return hangs ? own * vertical.hangShare : own;
}

/// The part of a tick in the hold phase, which ends at the apex at the latest.
MotionPart holdPhase(const VerticalTick& tick, double dt) {
    const double most = std::min(tick.holdLeft, dt), gain = tick.band.holdAcceleration;
    if (!(most > 0) || !(tick.speed > 0)) return {0, tick.speed, dt};
    const double time = tick.speed + gain * most > 0 ? most : -tick.speed / gain;
    const double after = time < most ? 0 : tick.speed + gain * time;
    return {0.5 * (tick.speed + after) * time, after, dt - time};
}

/// The hold phase, then the parabola, piece by piece: gravity changes at the hang speed, at the apex, and at the
/// terminal speed.
TickMotion fallExactly(const VerticalMotion& vertical, const VerticalTick& tick, double dt) {
    const MotionPart held = holdPhase(tick, dt);
    double speed = std::max(held.speed, -vertical.terminalSpeed), left = held.left, shift = held.shift;
    for (const double next : {vertical.hangSpeed, 0.0, -vertical.hangSpeed, -vertical.terminalSpeed}) {
        const double end = std::max(next, -vertical.terminalSpeed);
        if (!(speed > end) || !(left > 0)) continue;
        const double middle = 0.5 * (speed + end);
        const double gravity = gravityOf(vertical, tick, middle, middle < 0);
        const bool arrives = gravity * left >= speed - end;
        const double took = arrives ? (speed - end) / gravity : left;
        const double after = arrives ? end : speed - gravity * took;
        shift += 0.5 * (speed + after) * took;
        speed = after;
        left -= took;
    }
    return {shift + speed * left, speed};
}

}  // namespace

TickMotion verticalTick(const PlatformProfile& profile, const VerticalTick& tick, double dt) {
    const VerticalMotion& vertical = profile.vertical;
    if (vertical.order == TickOrder::Exact) return fallExactly(vertical, tick, dt);
    const TickUnits ticks(profile.grain, dt);
    const double speed = ticks.speed(tick.speed);
    const bool holds = tick.holdLeft > 0.5 * dt && speed > 0;
    double after = speed + (holds ? ticks.acceleration(tick.band.holdAcceleration)
                                  : -ticks.acceleration(gravityOf(vertical, tick, tick.speed, speed <= 0)));
    const double terminal = ticks.speed(vertical.terminalSpeed), unit = ticks.speed(vertical.terminalUnit);
    const double beyond = unit > 0 ? -after - std::floor(-after / unit) * unit : 0;
    const bool swings = unit > 0 && beyond < 0.5 * unit;
    if (-after >= terminal && !swings) after = -terminal;
    return {vertical.order == TickOrder::PositionFirst ? speed : after, ticks.perSecond(after)};
}

}  // namespace plumb::detail
