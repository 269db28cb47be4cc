// SPDX-License-Identifier: MIT
// The motions that repeat: on a circle, of a spring, of a pendulum.
#include <cmath>
#include <numbers>

#include <plumb/kinematics/circular.h>
#include <plumb/kinematics/oscillation.h>
#include <plumb/kinematics/pendulum.h>
#include <plumb/math/check.h>
#include <plumb/math/trig.h>

namespace plumb {
namespace {

/// The step with 1 / w as the unit of time: x = xx x0 + (theta slope) v0 / w, v = vv v0 - w (theta slope) x0.
struct UnitStep {
    double xx, vv, slope;
};

// Near z = 1: cos r and sin(r) / r by their series in r^2 = theta^2 (1 - z^2), of either sign, at most 1 in size. The
// next terms are below 1e-17.
UnitStep nearCritical(double z, double theta, double square) {
    double cosine = 1, sine = 1;
    for (int n = 9; n >= 1; --n) {
        cosine = 1 - cosine * square / ((2 * n - 1) * (2 * n));
        sine = 1 - sine * square / ((2 * n) * (2 * n + 1));
    }
    const double decay = exponential(-z * theta);
    if (decay == 0) return {0, 0, 0};
    return {decay * (cosine + z * theta * sine), decay * (cosine - z * theta * sine), decay * sine};
}

UnitStep underdamped(double z, double theta) {
    const double root = std::sqrt((1 - z) * (1 + z));
    const SinCos turn = sinCos(root * theta);
    const double decay = exponential(-z * theta);
    const double sine = turn.sin / root;
    return {decay * (turn.cos + z * sine), decay * (turn.cos - z * sine), decay * sine / theta};
}

// Two decay rates, z + root and its inverse. Their exponentials differ strongly here, theta root > 1: no cancellation.
UnitStep overdamped(double z, double theta) {
    const double root = std::sqrt(z - 1) * std::sqrt(z + 1);
    const double fast = z + root, slow = 1 / fast;
    const double slowly = exponential(-slow * theta), fastly = exponential(-fast * theta);
    const double fastPart = 0.5 * (fast / root), slowPart = 0.5 * (slow / root);
    return {fastPart * slowly - slowPart * fastly, fastPart * fastly - slowPart * slowly,
            0.5 * (slowly - fastly) / root / theta};
}

UnitStep unitStep(double z, double theta) {
    const double square = theta * (1 - z) * (theta * (1 + z));
    if (std::fabs(square) <= 1) return nearCritical(z, theta, square);
    return z < 1 ? underdamped(z, theta) : overdamped(z, theta);
}

/// Of two positive numbers, the larger first. Each iteration about doubles the number of digits that the two have in
/// common.
double arithmeticGeometricMean(double a, double b) {
    for (int i = 0; i < 40 && a - b > 1e-8 * a; ++i) {
        const double mean = 0.5 * (a + b);
        b = std::sqrt(a * b);
        a = mean;
    }
    return 0.5 * (a + b);
}

}  // namespace

CircularPoint circularAt(const CircularMotion& motion, double time) {
    requireFinite(motion.center, "CircularMotion.center");
    requireNotNegative(motion.radius, "CircularMotion.radius");
    requireFinite(motion.startAngle, "CircularMotion.startAngle");
    requireFinite(motion.angularVelocity, "CircularMotion.angularVelocity");
    requireFinite(time, "time");
    const double w = motion.angularVelocity;
    requireFinite(w * time, "CircularMotion.angularVelocity * time");
    requireFinite(motion.startAngle + w * time, "CircularMotion.startAngle + angularVelocity * time");
    requireFinite(w * (w * motion.radius), "CircularMotion.angularVelocity^2 * radius");
    const SinCos angle = sinCos(motion.startAngle + w * time);
    const Vec2 arm(motion.radius * angle.cos, motion.radius * angle.sin);
    return {motion.center + arm, w * perp(arm), -w * (w * arm)};
}

AxisMotion harmonicAt(const HarmonicMotion& motion, double time) {
    requireFinite(motion.amplitude, "HarmonicMotion.amplitude");
    requireFinite(motion.angularFrequency, "HarmonicMotion.angularFrequency");
    requireFinite(motion.phase, "HarmonicMotion.phase");
    requireFinite(time, "time");
    const double w = motion.angularFrequency;
    requireFinite(w * time, "HarmonicMotion.angularFrequency * time");
    requireFinite(w * time + motion.phase, "HarmonicMotion.angularFrequency * time + phase");
    requireFinite(motion.amplitude * w, "HarmonicMotion.amplitude * angularFrequency");
    const SinCos angle = sinCos(w * time + motion.phase);
    return {motion.amplitude * angle.cos, -motion.amplitude * w * angle.sin};
}

Oscillator oscillatorOf(double mass, double stiffness, double damping) {
    requirePositive(mass, "mass");
    requirePositive(stiffness, "stiffness");
    requireNotNegative(damping, "damping");
    const double rootOfBoth = std::sqrt(mass) * std::sqrt(stiffness);
    return {rootOfBoth / mass, 0.5 * damping / rootOfBoth};
}

std::optional<double> dampedPeriod(const Oscillator& oscillator) {
    const double w = oscillator.angularFrequency, z = oscillator.dampingRatio;
    requireNotNegative(w, "Oscillator.angularFrequency");
    requireNotNegative(z, "Oscillator.dampingRatio");
    if (w == 0 || z >= 1) return std::nullopt;
    return 2 * std::numbers::pi / (w * std::sqrt((1 - z) * (1 + z)));
}

OscillatorStep oscillatorStep(const Oscillator& oscillator, double time) {
    const double w = oscillator.angularFrequency;
    requireNotNegative(w, "Oscillator.angularFrequency");
    requireNotNegative(oscillator.dampingRatio, "Oscillator.dampingRatio");
    requireNotNegative(time, "time");
    const double theta = w * time;
    requireFinite(theta, "Oscillator.angularFrequency * time");
    const UnitStep step = unitStep(oscillator.dampingRatio, theta);
    return {step.xx, time * step.slope, -w * theta * step.slope, step.vv};
}

AxisMotion oscillate(const AxisMotion& from, double rest, const Oscillator& oscillator, double time) {
    requireFinite(from.position, "AxisMotion.position");
    requireFinite(from.velocity, "AxisMotion.velocity");
    requireFinite(rest, "rest");
    const OscillatorStep step = oscillatorStep(oscillator, time);
    const double x = from.position - rest;
    return {rest + (step.xx * x + step.xv * from.velocity), step.vx * x + step.vv * from.velocity};
}

PointMotion oscillate(const PointMotion& from, const Vec2& rest, const Oscillator& oscillator, double time) {
    requireFinite(from.position, "PointMotion.position");
    requireFinite(from.velocity, "PointMotion.velocity");
    requireFinite(rest, "rest");
    const OscillatorStep step = oscillatorStep(oscillator, time);
    const Vec2 x = from.position - rest;
    return {rest + (step.xx * x + step.xv * from.velocity), step.vx * x + step.vv * from.velocity};
}

double pendulumPeriod(const Pendulum& pendulum, double amplitude) {
    requirePositive(pendulum.inertia, "Pendulum", ".inertia");
    requirePositive(pendulum.mass, "Pendulum", ".mass");
    requirePositive(pendulum.distance, "Pendulum", ".distance");
    requirePositive(pendulum.gravity, "Pendulum", ".gravity");
    requireFinite(amplitude, "pendulumPeriod: amplitude");
    if (!(std::fabs(amplitude) < std::numbers::pi))
        refuse("pendulumPeriod: amplitude", toText(amplitude) + " is not between -pi and pi");
    const double square = pendulum.inertia / pendulum.mass / pendulum.distance / pendulum.gravity;
    const double small = 2 * std::numbers::pi * std::sqrt(square);
    const double period = small / arithmeticGeometricMean(1, sinCos(0.5 * std::fabs(amplitude)).cos);
    requireFinite(period, "pendulumPeriod: period");
    return period;
}

}  // namespace plumb
