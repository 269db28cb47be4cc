// SPDX-License-Identifier: MIT
// Where does y' = f(t, y) lead in one step of a given length?
//
// Each takes derivative f, called as State f(double time, const State& state), the time [s], the state and the step h
// [s], of either sign, and returns the state after the step. Each throws std::invalid_argument on a time or a step that
// is not finite, and on a derivative of another size than the state; overflow gives infinity or NaN. With z = h w for
// an oscillator of w [rad/s], and h L for a decay y' = -L y:
//
//               order  evaluations  oscillator        its energy, a step     decay         constant acceleration
//   Euler       1      1            never stable      (1 + z^2)              h L < 2       -a h t / 2
//   midpoint    2      2            never stable      (1 + z^4 / 4)          h L < 2       exact
//   Heun        2      2            never stable      (1 + z^4 / 4)          h L < 2       exact
//   RK4         4      4            z < 2 sqrt(2)     1 - z^6/72 + z^8/576   h L < 2.785   exact
//
// Source: Hairer, Norsett, Wanner, "Solving Ordinary Differential Equations I", II.1, and II, IV.2.
// Test: "the energy of an oscillator after 1,000 steps of z = 0.1", and its neighbours in fixed_step_test.cpp
#pragma once
#include <plumb/integrate/state.h>

namespace plumb {

/// y + h f(t, y). An oscillator gains energy at any step size: included to show the problem.
template <EigenState State, typename Derivative>
State explicitEulerStep(const Derivative& derivative, double time, const State& state, double step) {
    requireFinite(time, "time");
    requireFinite(step, "step");
    const State slope = derivative(time, state);
    requireSizeOf(state, slope, "derivative", "state");
    return state + step * slope;
}

/// y + h f(t + h/2, y + h/2 f(t, y)).
template <EigenState State, typename Derivative>
State midpointStep(const Derivative& derivative, double time, const State& state, double step) {
    const State middle = explicitEulerStep(derivative, time, state, 0.5 * step);
    const State slope = derivative(time + 0.5 * step, middle);
    return state + step * slope;
}

/// y + h (k1 + k2) / 2, the slopes at the start and at the end as predicted by Euler's step: the trapezium rule. Where
/// f is linear it equals the midpoint method. Source: Heun, 1900.
template <EigenState State, typename Derivative>
State heunStep(const Derivative& derivative, double time, const State& state, double step) {
    requireFinite(time, "time");
    requireFinite(step, "step");
    const State start = derivative(time, state);
    requireSizeOf(state, start, "derivative", "state");
    const State end = derivative(time + step, State(state + step * start));
    return state + 0.5 * step * (start + end);
}

/// y + h (k1 + 2 k2 + 2 k3 + k4) / 6, the slopes at the start, twice at the middle, and at the end. Source: Kutta,
/// 1901.
template <EigenState State, typename Derivative>
State rungeKutta4Step(const Derivative& derivative, double time, const State& state, double step) {
    requireFinite(time, "time");
    requireFinite(step, "step");
    const double middle = time + 0.5 * step;
    const State k1 = derivative(time, state);
    requireSizeOf(state, k1, "derivative", "state");
    const State k2 = derivative(middle, State(state + 0.5 * step * k1));
    const State k3 = derivative(middle, State(state + 0.5 * step * k2));
    const State k4 = derivative(time + step, State(state + step * k3));
    return state + step / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
}

}  // namespace plumb
