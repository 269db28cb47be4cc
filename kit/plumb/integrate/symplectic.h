// SPDX-License-Identifier: MIT
// Where does x'' = a(t, x, v) lead in one step, without a drift of energy in the long run?
//
// Each takes acceleration a, called as State a(double time, const State& position, const State& velocity), the time
// [s], position and velocity, and the step h [s], of either sign. Each throws std::invalid_argument on a time or a step
// that is not finite, and on a velocity or an acceleration of another size than the position. For an oscillator of w
// [rad/s], with z = h w, each conserves a modified ("shadow") energy to rounding, which keeps the energy near it:
//
//                    order  stable  shadow                         energy over shadow                   free fall
//   semi-implicit    1      z < 2   v^2 + w^2 x^2 - h w^2 x v      1 / (1 + z / 2) to 1 / (1 - z / 2)   +a h t / 2
//   velocity Verlet  2      z < 2   v^2 + w^2 x^2 (1 - z^2 / 4)    1 to 1 / (1 - z^2 / 4)               exact
//
// Both conserve angular momentum about a center to rounding. If a depends on v, the orders hold, but not the rest.
// Source: Hairer, Lubich, Wanner, "Geometric Numerical Integration", I.1 and I.5.
// Tests: "semi-implicit Euler and velocity Verlet keep their shadow of the energy", "only the symplectic pair
// keeps angular momentum over ten Kepler orbits", and their neighbours
#pragma once
#include <plumb/integrate/state.h>

namespace plumb {

/// Position and velocity: both of the same size.
template <EigenState State>
struct Phase {
    State position;
    State velocity;
};

/// v' = v + h a(t, x, v), x' = x + h v': the method that most games use. Also called symplectic Euler.
template <EigenState State, typename Acceleration>
Phase<State> semiImplicitEulerStep(const Acceleration& acceleration, double time, const Phase<State>& from,
                                   double step) {
    requireFinite(time, "time");
    requireFinite(step, "step");
    requireSizeOf(from.position, from.velocity, "velocity", "position");
    const State start = acceleration(time, from.position, from.velocity);
    requireSizeOf(from.position, start, "acceleration", "position");
    const State velocity = from.velocity + step * start;
    return {from.position + step * velocity, velocity};
}

/// x' = x + h v + h^2 a / 2, v' = v + h (a + a') / 2, with a' at x' and, where it asks for a velocity, at v + h a.
/// Also called leapfrog. Source: Swope et al., J. Chem. Phys. 76, 1982; the velocity after Groot and Warren, 1997.
template <EigenState State, typename Acceleration>
Phase<State> velocityVerletStep(const Acceleration& acceleration, double time, const Phase<State>& from, double step) {
    requireFinite(time, "time");
    requireFinite(step, "step");
    requireSizeOf(from.position, from.velocity, "velocity", "position");
    const State start = acceleration(time, from.position, from.velocity);
    requireSizeOf(from.position, start, "acceleration", "position");
    const State half = from.velocity + 0.5 * step * start;
    const State position = from.position + step * half;
    const State end = acceleration(time + step, position, State(from.velocity + step * start));
    return {position, half + 0.5 * step * end};
}

}  // namespace plumb
