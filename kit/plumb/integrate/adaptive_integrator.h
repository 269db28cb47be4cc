// SPDX-License-Identifier: MIT
// Where does y' = f(t, y) lead in steps whose length is adapted to a tolerance?
#pragma once
#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include <plumb/integrate/dormand_prince.h>
#include <plumb/integrate/step_control.h>

namespace plumb {

/// Why an integration ended.
enum class IntegrationEnd {
    Reached,       ///< the end time was reached
    Crossed,       ///< the watched quantity crossed zero
    StepTooSmall,  ///< even the smallest step that changes the time is not accurate enough: a discontinuity, or a pole
    TooManySteps,  ///< AdaptiveSettings.maxSteps steps were tried
    NotFinite      ///< even for the smallest step, the derivative or the state is not finite
};

/// Integrates from one time to another, in either direction, step by step, so that a caller can inspect the steps or
/// stop early; integrate() makes all steps. Derivative is as in fixed_step.h. The error of each step is limited by
/// AdaptiveSettings. At the end the error is at most the tolerance times the number of steps, for an equation that does
/// not amplify errors; energy drifts as slowly. The number of steps is always limited.
/// Throws std::invalid_argument on a time or a state that is not finite, a derivative of another size, invalid
/// settings.
/// Source: Dormand and Prince's pair with local extrapolation; step control after Hairer, Norsett, Wanner, II.4.
/// Tests: "an oscillator is within the tolerance times the steps after 100 s", "whatever is integrated ends, and says
/// why"
template <EigenState State, typename Derivative>
class AdaptiveIntegrator {
public:
    AdaptiveIntegrator(Derivative derivative, double time, const State& state, double endTime,
                       const AdaptiveSettings& settings = {})
        : derivative_(std::move(derivative)), settings_(settings), time_(time), endTime_(endTime) {
        requireFinite(time, "time");
        requireFinite(endTime, "endTime");
        requireFinite(endTime - time, "endTime - time");
        requireSettings(settings);
        for (const double number : numbersOf(state)) requireFinite(number, "state");
        made_.end = state;
        made_.slope = derivative_(time, state);
        requireSizeOf(state, made_.slope, "derivative", "state");
        made_.start = state;
        startTime_ = time;
        finite_ = std::isfinite(ratioOf(made_.slope, state, state));
        step_ = std::copysign(firstStep(), endTime - time);
    }

    /// Makes a step; false when there is no further step: end() gives the reason.
    bool advance() {
        while (time_ != endTime_ && tried_ < settings_.maxSteps) {
            const double left = endTime_ - time_;
            const bool last = std::fabs(step_) >= std::fabs(left);
            const double step = last ? left : step_;
            if (!last && isTooSmall(step)) {
                end_ = finite_ ? IntegrationEnd::StepTooSmall : IntegrationEnd::NotFinite;
                return false;
            }
            ++tried_;
            const DormandPrinceStep<State> tried = dormandPrinceStep(derivative_, time_, made_.end, made_.slope, step);
            if (take(tried, step, last ? endTime_ : time_ + step)) return true;
        }
        end_ = time_ == endTime_ ? IntegrationEnd::Reached : IntegrationEnd::TooManySteps;
        return false;
    }

    double time() const { return time_; }                               ///< after the last step [s]
    double startTime() const { return startTime_; }                     ///< time before the last step [s]
    const DormandPrinceStep<State>& lastStep() const { return made_; }  ///< its start, its end, and its interpolant
    IntegrationEnd end() const { return end_; }                         ///< valid once advance() is false
    int accepted() const { return accepted_; }
    int rejected() const { return tried_ - accepted_; }

private:
    static std::span<const double> numbersOf(const State& state) {
        return {state.data(), static_cast<std::size_t>(state.size())};
    }
    double ratioOf(const State& value, const State& before, const State& after) const {
        return worstRatio(numbersOf(value), numbersOf(before), numbersOf(after), settings_);
    }
    double limited(double step) const { return settings_.maxStep > 0 ? std::min(step, settings_.maxStep) : step; }

    bool isTooSmall(double step) const { return std::fabs(step) <= 0x1p-50 * std::fabs(time_) + 1e-300; }

    double firstStep() {
        if (settings_.firstStep > 0) return limited(settings_.firstStep);
        const State &state = made_.end, &slope = made_.slope;
        const double slopeRatio = ratioOf(slope, state, state);
        const auto changeWithin = [&](double guess) {
            const double there = std::copysign(guess, endTime_ - time_);
            return State(derivative_(time_ + there, State(state + there * slope)) - slope);
        };
        double guess = std::min(firstStepGuess(ratioOf(state, state, state), slopeRatio), std::fabs(endTime_ - time_));
        State change = changeWithin(guess);
        // The equation may not be defined that far away.
        while (finite_ && !change.allFinite() && !isTooSmall(guess)) change = changeWithin(guess *= 0.1);
        if (!change.allFinite()) finite_ = false;
        return limited(firstStepFrom(guess, slopeRatio, ratioOf(change, state, state) / guess));
    }

    bool take(const DormandPrinceStep<State>& tried, double step, double time) {
        const double error = ratioOf(tried.error, tried.start, tried.end);
        finite_ = std::isfinite(error);
        double factor = stepFactor(error);
        if (!(error <= 1)) {
            step_ = step * std::min(factor, 0.9);
            mayGrow_ = false;
            return false;
        }
        if (!mayGrow_) factor = std::min(factor, 1.0);  // a shortened step is not lengthened at once
        mayGrow_ = true;
        step_ = std::copysign(limited(std::fabs(step) * factor), step);
        startTime_ = std::exchange(time_, time);
        made_ = tried;
        ++accepted_;
        return true;
    }

    Derivative derivative_;
    AdaptiveSettings settings_;
    DormandPrinceStep<State> made_;
    double time_, endTime_, startTime_ = 0, step_ = 0;
    IntegrationEnd end_ = IntegrationEnd::Reached;
    int accepted_ = 0, tried_ = 0;
    bool finite_ = true, mayGrow_ = true;
};

}  // namespace plumb
