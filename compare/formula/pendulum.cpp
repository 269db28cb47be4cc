// SPDX-License-Identifier: MIT
#include <compare/formula/pendulum.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace plumb::compare {
namespace {

/// One step of the arithmetic-geometric mean.
struct Means {
    double a;  ///< arithmetic
    double b;  ///< geometric
    double c;  ///< half the difference of the two before
};

/// The steps from (1, complement) on, until both means are equal. At each step, the number of correct digits doubles.
std::vector<Means> meansOf(double modulus, double complement) {
    std::vector<Means> steps{{1, complement, modulus}};
    while (std::abs(steps.back().c) > 1e-16 && steps.size() < 20) {
        const auto [a, b, c] = steps.back();
        steps.push_back({(a + b) / 2, std::sqrt(a * b), (a - b) / 2});
    }
    return steps;
}

/// The amplitude phi = am(u, k): sn u = sin phi, cn u = cos phi.
double jacobiAmplitude(double u, const std::vector<Means>& means) {
    double phi = std::ldexp(means.back().a * u, static_cast<int>(means.size()) - 1);
    for (std::size_t n = means.size() - 1; n > 0; --n) {
        phi = (phi + std::asin(std::clamp(means[n].c / means[n].a * std::sin(phi), -1.0, 1.0))) / 2;
    }
    return phi;
}

}  // namespace

double periodOf(const Pendulum& pendulum) {
    const double half = pendulum.amplitude / 2;
    const double small = 2 * std::numbers::pi * std::sqrt(pendulum.equivalentLength / pendulum.gravity);
    return small / meansOf(std::sin(half), std::cos(half)).back().a;
}

Swing swingAt(const Pendulum& pendulum, double t) {
    const double modulus = std::sin(pendulum.amplitude / 2);
    const std::vector<Means> means = meansOf(modulus, std::cos(pendulum.amplitude / 2));
    const double quarter = std::numbers::pi / (2 * means.back().a);
    const double rate = std::sqrt(pendulum.gravity / pendulum.equivalentLength);
    // Whole periods turn phi by whole turns. Without them the phase keeps its digits.
    const double phase = std::remainder(rate * t, 4 * quarter);
    const double phi = jacobiAmplitude(phase + quarter, means);
    return {2 * std::asin(std::clamp(modulus * std::sin(phi), -1.0, 1.0)), 2 * modulus * rate * std::cos(phi)};
}

double riseOf(const BallisticPendulum& pendulum) {
    const double together = pendulum.bullet * pendulum.speed / (pendulum.bullet + pendulum.block);
    return together * together / (2 * pendulum.gravity);
}

double amplitudeOf(const BallisticPendulum& pendulum) {
    return 2 * std::asin(std::sqrt(riseOf(pendulum) / (2 * pendulum.length)));
}

}  // namespace plumb::compare
