// SPDX-License-Identifier: MIT
// How long may a step be so that its error stays small enough?
#pragma once
#include <span>

namespace plumb {

/// A step is accepted when the error of every component is at most absoluteTolerance + relativeTolerance |y|.
struct AdaptiveSettings {
    double absoluteTolerance = 1e-9;  ///< of each component, in its unit; >= 0
    double relativeTolerance = 1e-9;  ///< >= 0, not both 0 [-]
    double firstStep = 0;             ///< 0: chosen from the derivative at the start [s]
    double maxStep = 0;               ///< 0: limited by the error only [s]
    int maxSteps = 100'000;           ///< including rejected steps
};

/// Throws std::invalid_argument that names the field.
void requireSettings(const AdaptiveSettings& settings);

/// The largest of |value| / (absoluteTolerance + relativeTolerance max(|before|, |after|)) [-]; infinity where
/// a number is not finite.
double worstRatio(std::span<const double> value, std::span<const double> before, std::span<const double> after,
                  const AdaptiveSettings& settings);

/// The factor for the length of the next step, where error is the worstRatio of this one: 0.9 error^(-1/5), within 0.2
/// to 5.
/// Source: Hairer, Norsett, Wanner, "Solving Ordinary Differential Equations I", II.4. Test: "a step that was 32
/// times too wrong is tried again at 0.45 of its length"
double stepFactor(double error);

/// The length of the first step of a method of fifth order [s], from the ratios of the state [-], of its derivative
/// [1/s] and of its second derivative [1/s^2]: neither far too long nor far too short. Source: the same.
double firstStepGuess(double state, double slope);
double firstStepFrom(double guess, double slope, double bend);

/// x^(1/5) for x >= 0, within 2 units in the last place, by Newton's method: std::pow's bits differ between machines.
/// Test: "the fifth root is within 2 of the last place, from 5e-324 to 1.8e308"
double fifthRoot(double x);

}  // namespace plumb
