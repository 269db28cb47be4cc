// SPDX-License-Identifier: MIT
#include <plumb/kinematics/oscillation.h>

#include <cmath>
#include <numbers>

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

}  // namespace

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

}  // namespace plumb
