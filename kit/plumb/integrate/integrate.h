// SPDX-License-Identifier: MIT
// Where does y' = f(t, y) lead by a given time, or when does a quantity first become zero?
#pragma once
#include <functional>
#include <optional>
#include <utility>

#include <plumb/integrate/adaptive_integrator.h>

namespace plumb {

template <EigenState State>
struct Integration {
    IntegrationEnd end = IntegrationEnd::Reached;  ///< Reached or Crossed, unless integration failed
    double time = 0;                               ///< the time reached [s]
    State state;                                   ///< the state at that time
    int accepted = 0, rejected = 0;                ///< steps made, and steps repeated with a shorter length
};

/// From time to endTime [s], in either direction, by an AdaptiveIntegrator: see there for errors, tolerances and ends.
///   integrate([](double t, const State& y) -> State { ... }, 0, start, 10).state
template <EigenState State, typename Derivative>
Integration<State> integrate(Derivative derivative, double time, const State& state, double endTime,
                             const AdaptiveSettings& settings = {}) {
    AdaptiveIntegrator<State, Derivative> walk(std::move(derivative), time, state, endTime, settings);
    while (walk.advance()) {
    }
    return {walk.end(), walk.time(), walk.lastStep().end, walk.accepted(), walk.rejected()};
}

/// Which zero crossings count: from below (rising), from above (falling), or both.
enum class ZeroCrossing { Either, Rising, Falling };

/// Where a quantity, as a function of the fraction of a step, first crosses zero; and its sign at the end, for the next
/// step.
struct CrossingSearch {
    std::optional<double> fraction;  ///< [-]
    int sign = 0;                    ///< 1 or -1; 0 while it has been zero only
};
CrossingSearch findCrossing(const std::function<double(double)>& quantity, int signBefore, ZeroCrossing crossing);

/// The same until quantity g, called as double g(double time, const State& state), first crosses or reaches zero; a
/// start at zero is no crossing. It is evaluated at eight places per step, then bisected to the last place of the
/// step's interpolant of fourth order: two crossings within an eighth of a step may be missed, which
/// AdaptiveSettings.maxStep can prevent. NaN is no crossing. Ends at endTime when there is none.
/// Test: "the time at which a thrown ball comes down is the closed form's, 1,000,000 times"
template <EigenState State, typename Derivative, typename Quantity>
Integration<State> integrateUntil(Derivative derivative, double time, const State& state, double endTime,
                                  const Quantity& quantity, ZeroCrossing crossing = ZeroCrossing::Either,
                                  const AdaptiveSettings& settings = {}) {
    AdaptiveIntegrator<State, Derivative> walk(std::move(derivative), time, state, endTime, settings);
    const auto timeAt = [&](double fraction) {
        return fraction == 1 ? walk.time() : walk.startTime() + fraction * (walk.time() - walk.startTime());
    };
    const auto stateAt = [&](double fraction) {
        return fraction == 1 ? walk.lastStep().end : walk.lastStep().at(fraction);
    };
    const double atStart = quantity(time, state);
    CrossingSearch search{{}, (atStart > 0) - (atStart < 0)};
    while (walk.advance()) {
        search = findCrossing([&](double fraction) { return quantity(timeAt(fraction), stateAt(fraction)); },
                              search.sign, crossing);
        if (search.fraction)
            return {IntegrationEnd::Crossed, timeAt(*search.fraction), stateAt(*search.fraction), walk.accepted(),
                    walk.rejected()};
    }
    return {walk.end(), walk.time(), walk.lastStep().end, walk.accepted(), walk.rejected()};
}

}  // namespace plumb
