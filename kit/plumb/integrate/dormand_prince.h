// SPDX-License-Identifier: MIT
// Where does y' = f(t, y) lead in one step of fifth order, with which error, and what is the state in between?
#pragma once
#include <plumb/integrate/state.h>

namespace plumb {

/// The result of a step.
template <EigenState State>
struct DormandPrinceStep {
    State start, end;              ///< the state before and after, of fifth order
    State slope;                   ///< f at the end: the first evaluation of the next step
    State error;                   ///< end minus the embedded solution of fourth order
    State dense3, dense4, dense5;  ///< coefficients of the interpolant (dense output)

    /// The state at a fraction of the step [-], 0 to 1, of fourth order. Source: Hairer, Norsett, Wanner, II.6.
    State at(double fraction) const {
        const double rest = 1 - fraction;
        return start + fraction * (end - start + rest * (dense3 + fraction * (dense4 + rest * dense5)));
    }
};

/// A step h [s] from time t [s], of either sign, with slope = f(t, y) from the step before: six evaluations. With fixed
/// steps the method is of order 5; an oscillator keeps 1 - z^6 / 1800 + z^8 / 1600 of its energy per step, z = h w, and
/// is stable for z < 0.997.
/// Source: Dormand and Prince, J. Comp. Appl. Math. 6, 1980; coefficients as in Hairer, Norsett, Wanner, II.5.
/// Test: "halving the step divides the error by 2 to the power of the order"
template <EigenState State, typename Derivative>
DormandPrinceStep<State> dormandPrinceStep(const Derivative& derivative, double time, const State& state,
                                           const State& slope, double step) {
    const double h = step;
    const State& k1 = slope;
    const State k2 = derivative(time + h / 5, State(state + h / 5 * k1));
    const State k3 = derivative(time + 3 * h / 10, State(state + h * (3.0 / 40 * k1 + 9.0 / 40 * k2)));
    const State k4 = derivative(time + 4 * h / 5, State(state + h * (44.0 / 45 * k1 - 56.0 / 15 * k2 + 32.0 / 9 * k3)));
    const State k5 = derivative(time + 8 * h / 9, State(state + h * (19372.0 / 6561 * k1 - 25360.0 / 2187 * k2 +
                                                                     64448.0 / 6561 * k3 - 212.0 / 729 * k4)));
    const State k6 =
        derivative(time + h, State(state + h * (9017.0 / 3168 * k1 - 355.0 / 33 * k2 + 46732.0 / 5247 * k3 +
                                                49.0 / 176 * k4 - 5103.0 / 18656 * k5)));
    DormandPrinceStep<State> made;
    made.start = state;
    made.end =
        state + h * (35.0 / 384 * k1 + 500.0 / 1113 * k3 + 125.0 / 192 * k4 - 2187.0 / 6784 * k5 + 11.0 / 84 * k6);
    made.slope = derivative(time + h, made.end);
    const State& k7 = made.slope;
    made.error = h * (71.0 / 57600 * k1 - 71.0 / 16695 * k3 + 71.0 / 1920 * k4 - 17253.0 / 339200 * k5 +
                      22.0 / 525 * k6 - 1.0 / 40 * k7);
    const State change = made.end - state;
    made.dense3 = h * k1 - change;
    made.dense4 = change - h * k7 - made.dense3;
    made.dense5 = h * (-12715105075.0 / 11282082432.0 * k1 + 87487479700.0 / 32700410799.0 * k3 -
                       10690763975.0 / 1880347072.0 * k4 + 701980252875.0 / 199316789632.0 * k5 -
                       1453857185.0 / 822651844.0 * k6 + 69997945.0 / 29380423.0 * k7);
    return made;
}

}  // namespace plumb
