// SPDX-License-Identifier: MIT
#include <compare/closed_form/motion.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <compare/formula/kepler.h>
#include <compare/formula/oscillator.h>
#include <compare/formula/pendulum.h>

namespace plumb::compare {
namespace {

BodyState stateOf(const PiecewiseMotion& motion, const BodyDef&, double t) {
    const auto next = std::ranges::upper_bound(motion.flights, t, {}, &Flight::start);
    if (next == motion.flights.begin()) return unknownState();
    const Flight& flight = *std::prev(next);
    const double s = t - flight.start;
    return {flight.position + flight.velocity * s + flight.acceleration * (s * s / 2),
            flight.angle + flight.angularVelocity * s + flight.angularAcceleration * (s * s / 2),
            flight.velocity + flight.acceleration * s, flight.angularVelocity + flight.angularAcceleration * s};
}

/// x = x0 + (v0 - g / k) (1 - e^(-k t)) / k + g t / k,  v = g / k + (v0 - g / k) e^(-k t)
/// k damping [1/s], g acceleration [m/s^2]. The motion does not describe the rotation, so that is the body's own: free,
/// and damped if the body is.
/// Source: dv/dt = g - k v. Test: "a shot of 20 m/s at 45 degrees with k = 0.2 lands at 29.09 m"
BodyState stateOf(const DampedFlight& motion, const BodyDef& def, double t) {
    const double k = motion.damping;
    const Vec2 terminal = motion.acceleration / k;
    const Vec2 excess = motion.velocity - terminal;
    const double turned = def.angularDamping > 0 ? -std::expm1(-def.angularDamping * t) / def.angularDamping : t;
    return {motion.position + excess * (-std::expm1(-k * t) / k) + terminal * t,
            def.angle + def.angularVelocity * turned, terminal + excess * std::exp(-k * t),
            def.angularVelocity * std::exp(-def.angularDamping * t)};
}

/// theta, and 0 while it hangs still: before its time, and on the side on which others swing instead of it.
Swing swingOf(const PendulumMotion& motion, double t) {
    const Pendulum pendulum{motion.equivalentLength, motion.gravity, motion.amplitude};
    if (motion.from > 0 && t < motion.from) return {0, 0};
    // A pendulum released at rest at its amplitude passes straight down, on its way back up to it, after three quarters
    // of a period.
    const double since = motion.from > 0 ? t - motion.from + 0.75 * periodOf(pendulum) : t;
    const Swing swing = swingAt(pendulum, since);
    const bool handedOn =
        (motion.side == Side::Left && swing.angle > 0) || (motion.side == Side::Right && swing.angle < 0);
    return handedOn ? Swing{0, 0} : swing;
}

BodyState stateOf(const PendulumMotion& motion, const BodyDef&, double t) {
    const Swing swing = swingOf(motion, t);
    const double sine = std::sin(swing.angle);
    const double cosine = std::cos(swing.angle);
    const double turned = motion.turns ? swing.angle - swingOf(motion, 0).angle : 0;
    const Vec2 approach = t < motion.from ? motion.approach : Vec2(0, 0);
    return {motion.pivot + motion.length * Vec2(sine, -cosine) + approach * (t - motion.from),
            motion.bodyAngle + turned, motion.length * swing.angularVelocity * Vec2(cosine, sine) + approach,
            motion.turns ? swing.angularVelocity : 0};
}

BodyState stateOf(const OscillatorMotion& motion, const BodyDef& def, double t) {
    const Displacement x =
        displacementAt({motion.mass, motion.stiffness, motion.damping, motion.offset, motion.speed}, t);
    return {motion.rest + x.value * motion.direction, def.angle, x.speed * motion.direction, 0};
}

/// Source: m v' = m g - c v^2; v = v_t tanh(g t / v_t).
/// Test: "what falls with drag is at 25.748172225 m/s after 3 s, 41.234527650 m down"
BodyState stateOf(const DragFall& motion, const BodyDef& def, double t) {
    const double v = motion.terminalSpeed, x = motion.gravity * t / v;
    const double lnCosh = x + std::log1p(std::exp(-2 * x)) - std::log(2.0);
    return {motion.position - Vec2(0, v * v / motion.gravity * lnCosh),
            def.angle + def.angularVelocity * t,
            {0, -v * std::tanh(x)},
            def.angularVelocity};
}

BodyState stateOf(const KeplerMotion& motion, const BodyDef& def, double t) {
    const KeplerState state = keplerState({motion.semiMajorAxis, motion.eccentricity, motion.period}, motion.since + t);
    const auto turned = [&](const Vec2& v) { return Vec2(v.x() * motion.nearEnd + v.y() * perp(motion.nearEnd)); };
    return {motion.focus + motion.drift * t + turned(state.position), def.angle + def.angularVelocity * t,
            motion.drift + turned(state.velocity), def.angularVelocity};
}

}  // namespace

BodyState unknownState() {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return {{nan, nan}, nan, {nan, nan}, nan};
}

BodyState motionState(const BodyMotion& motion, const BodyDef& def, double t) {
    const auto known = [&](const auto& m) {
        if constexpr (requires { stateOf(m, def, t); })
            return stateOf(m, def, t);
        else
            return unknownState();
    };
    return std::visit(known, motion);
}

}  // namespace plumb::compare
