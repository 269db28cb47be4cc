// SPDX-License-Identifier: MIT
#include <plumb/integrate/step_control.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <plumb/math/check.h>

namespace plumb {

void requireSettings(const AdaptiveSettings& settings) {
    requireNotNegative(settings.absoluteTolerance, "AdaptiveSettings.absoluteTolerance");
    requireNotNegative(settings.relativeTolerance, "AdaptiveSettings.relativeTolerance");
    if (settings.absoluteTolerance == 0 && settings.relativeTolerance == 0)
        refuse("AdaptiveSettings.relativeTolerance", "0 is not positive, nor is absoluteTolerance");
    requireNotNegative(settings.firstStep, "AdaptiveSettings.firstStep");
    requireNotNegative(settings.maxStep, "AdaptiveSettings.maxStep");
    requirePositive(settings.maxSteps, "AdaptiveSettings.maxSteps");
}

double worstRatio(std::span<const double> value, std::span<const double> before, std::span<const double> after,
                  const AdaptiveSettings& settings) {
    double worst = 0;
    for (std::size_t i = 0; i < value.size(); ++i) {
        const double size = std::max(std::fabs(before[i]), std::fabs(after[i]));
        const double allowed = settings.absoluteTolerance + settings.relativeTolerance * size;
        const double ratio = value[i] == 0 ? 0 : std::fabs(value[i]) / allowed;
        if (std::isnan(ratio) || !std::isfinite(allowed)) return std::numeric_limits<double>::infinity();
        worst = std::max(worst, ratio);
    }
    return worst;
}

double stepFactor(double error) {
    if (error == 0) return 5;
    return std::clamp(0.9 / fifthRoot(error), 0.2, 5.0);
}

double firstStepGuess(double state, double slope) {
    return state < 1e-5 || slope < 1e-5 ? 1e-6 : 0.01 * state / slope;
}

double firstStepFrom(double guess, double slope, double bend) {
    const double largest = std::max(slope, bend);
    const double step = largest <= 1e-15 ? std::max(1e-6, 1e-3 * guess) : fifthRoot(0.01 / largest);
    return std::min(100 * guess, step);
}

double fifthRoot(double x) {
    if (x == 0 || !std::isfinite(x)) return x;
    int exponent = 0;
    double rest = std::frexp(x, &exponent);  // 0.5 <= rest < 1
    const int fifth = (exponent >= 0 ? exponent : exponent - 4) / 5;
    rest = std::ldexp(rest, exponent - 5 * fifth);  // 0.5 <= rest < 16
    double root = 0.9 + 0.06 * rest;                // within 8 %, from above after the first iteration
    for (int i = 0; i < 5; ++i) root -= 0.2 * (root - rest / (root * root * root * root));
    return std::ldexp(root, fifth);
}

}  // namespace plumb
