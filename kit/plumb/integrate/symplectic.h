// SPDX-License-Identifier: MIT
// Where does x'' = a(t, x, v) lead in one step, without losing energy in the long run?
//
// Each takes acceleration a, called as State a(double time, const State& position, const State& velocity), the time
// [s], where it is and how fast, and the step h [s], of either sign. Each throws std::invalid_argument on a time or a
// step that is not finite, and on an acceleration of another size than the position. With z = h w on an oscillator of
// w:
//
//                    order  evaluations  oscillator  its energy                        constant acceleration
//   semi-implicit    1      1            z < 2       within 1 / (1 -+ z / 2) of it     +a h t / 2
//   velocity Verlet  2      2            z < 2       from 1 - z^2 / 4 to 1 of it       exact
//
// Both keep a shadow of the energy to rounding: v^2 + w^2 x^2 - h w^2 x v, and v^2 + w^2 x^2 (1 - z^2 / 4); both keep
// angular momentum about a center. All this while a does not depend on v; where it does, the orders stay.
// Source: Hairer, Lubich, Wanner, "Geometric Numerical Integration", I.1 and I.5.
// Test: "semi-implicit Euler and velocity Verlet keep their shadow of the energy", and its neighbours
#pragma once
#include <plumb/integrate/state.h>

namespace plumb {

/// Where it is and how fast: each of the same size.
template <EigenState State>
struct Phase {
    State position;
    State velocity;
};

/// v' = v + h a(t, x, v), x' = x + h v': the one most games have. Also called symplectic Euler.
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
