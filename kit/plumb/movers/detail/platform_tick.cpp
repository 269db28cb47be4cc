// SPDX-License-Identifier: MIT
#include <plumb/movers/detail/platform_tick.h>

#include <algorithm>
#include <cmath>

namespace plumb::detail {

namespace {

/// Speeds as ways in a tick, and accelerations as what a tick adds to those; both of whole grains, where there are any.
class Ticks {
public:
    Ticks(double grain, double dt) : grain_(grain), dt_(dt) {}
    double speed(double metresPerSecond) const { return whole(metresPerSecond * dt_); }
    double acceleration(double a) const { return whole(a * dt_ * dt_); }
    double perSecond(double way) const { return way / dt_; }

private:
    double whole(double way) const { return grain_ > 0 ? std::round(way / grain_) * grain_ : way; }
    double grain_, dt_;
};

double toward(double from, double to, double most) {
    return from < to ? std::min(from + most, to) : std::max(from - most, to);
}

/// In a part of a tick, 0 to 1.
struct Stretch {
    double shift = 0, speed = 0, left = 0;  ///< left: of the tick
};

/// At a constant acceleration to a speed, and on at that.
Stretch approach(double speed, double to, double acceleration, double time) {
    const double away = std::fabs(to - speed);
    if (away > acceleration * time) {
        const double after = toward(speed, to, acceleration * time);
        return {0.5 * (speed + after) * time, after, 0};
    }
    const double took = acceleration > 0 ? away / acceleration : 0;
    return {0.5 * (speed + to) * took, to, time - took};
}

double accelerationOf(const LevelMotion& level, const LevelTick& tick) {
    const bool fast = !tick.runs && level.fastSpeed && std::fabs(tick.speed) >= *level.fastSpeed * (1 - 1e-12);
    const double own = fast ? level.fastAcceleration : tick.runs ? level.runAcceleration : level.walkAcceleration;
    const double shared = tick.onFloor ? own : own * level.airShare;
    if (tick.move == 0) return (tick.onFloor ? level.friction : level.airFriction).value_or(shared);
    return shared;
}

double cutTo(double grain, double way) {
    return grain > 0 ? std::trunc(way / grain) * grain : way;
}

}  // namespace

TickMotion levelTick(const PlatformProfile& profile, const LevelTick& tick, double dt) {
    const LevelMotion& level = profile.level;
    const Ticks ticks(profile.grain, dt);
    double speed = ticks.speed(tick.speed);
    const double own = tick.runs ? level.runSpeed : level.walkSpeed;
    const double target = ticks.speed(tick.move * std::min(own, tick.most.value_or(own)));
    double gain = ticks.acceleration(accelerationOf(level, tick));
    const bool turns = tick.move * speed < 0;
    const double turnGain = turns ? gain * level.turnFactor : gain;
    if (turns && tick.onFloor && std::fabs(speed) < ticks.speed(level.turnStopSpeed)) speed = 0;
    const bool over = tick.move * target > 0 && tick.move * speed > tick.move * target;
    if (over && level.overSpeed == OverSpeed::Cut) speed = target;
    if (over && level.overSpeed == OverSpeed::Slow)
        gain = ticks.acceleration((tick.onFloor ? level.friction : level.airFriction).value_or(gain / (dt * dt)));
    if (level.order == TickOrder::Exact) {
        Stretch way{0, speed, 1};
        if (turns) way = approach(speed, 0, turnGain, 1);
        const Stretch rest = approach(way.speed, target, gain, way.left);
        return {way.shift + rest.shift + rest.speed * rest.left, ticks.perSecond(rest.speed)};
    }
    const double after = toward(speed, target, turns ? turnGain : gain);
    const double shift = level.order == TickOrder::PositionFirst ? speed : after;
    return {cutTo(level.moveGrain, shift), ticks.perSecond(after)};
}

namespace {

double gravityOf(const VerticalMotion& vertical, const VerticalTick& tick, double speed, bool downward) {
    const double own = downward ? tick.band.fallGravity : tick.rises ? tick.band.riseGravity : tick.band.releaseGravity;
    const bool hangs = tick.held && std::fabs(speed) < vertical.hangSpeed;
    return hangs ? own * vertical.hangShare : own;
}

/// The parabola, stretch by stretch: gravity changes at the hang speed, at the apex, and at the terminal speed.
TickMotion fallExactly(const VerticalMotion& vertical, const VerticalTick& tick, double dt) {
    double speed = std::max(tick.speed, -vertical.terminalSpeed), left = dt, shift = 0;
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
    const Ticks ticks(profile.grain, dt);
    const double speed = ticks.speed(tick.speed);
    double after = speed - ticks.acceleration(gravityOf(vertical, tick, tick.speed, speed <= 0));
    const double terminal = ticks.speed(vertical.terminalSpeed), unit = ticks.speed(vertical.terminalUnit);
    const double beyond = unit > 0 ? -after - std::floor(-after / unit) * unit : 0;
    const bool swings = unit > 0 && beyond < 0.5 * unit;
    if (-after >= terminal && !swings) after = -terminal;
    return {vertical.order == TickOrder::PositionFirst ? speed : after, ticks.perSecond(after)};
}

}  // namespace plumb::detail
