// SPDX-License-Identifier: MIT
// Where does a force take a thing? By fine steps of fourth order, which know nothing of closed forms.
#pragma once
#include <Eigen/Core>

namespace plumb::test {

/// Position and velocity, or those of several one after the other.
template <int Size>
using State = Eigen::Matrix<double, Size, 1>;

/// Steps of the classical Runge-Kutta method; rate(state) is its time derivative.
template <int Size, typename Rate>
State<Size> integrated(State<Size> state, double time, int steps, const Rate& rate) {
    const double h = time / steps;
    for (int i = 0; i < steps; ++i) {
        const State<Size> k1 = rate(state);
        const State<Size> k2 = rate(State<Size>(state + h / 2 * k1));
        const State<Size> k3 = rate(State<Size>(state + h / 2 * k2));
        const State<Size> k4 = rate(State<Size>(state + h * k3));
        state += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    return state;
}

}  // namespace plumb::test
