// SPDX-License-Identifier: MIT
// What do all methods make of the same x'' = a(t, x, v)?
#pragma once
#include <array>

#include <Eigen/Core>

#include <plumb/integrate/dormand_prince.h>
#include <plumb/integrate/fixed_step.h>
#include <plumb/integrate/symplectic.h>

namespace plumb::test {

/// In the order of the lecture's table.
enum class Method { ExplicitEuler, SemiImplicitEuler, VelocityVerlet, Midpoint, Heun, RungeKutta4, DormandPrince };
constexpr std::array<Method, 7> methods = {
    Method::ExplicitEuler, Method::SemiImplicitEuler, Method::VelocityVerlet, Method::Midpoint,
    Method::Heun,          Method::RungeKutta4,       Method::DormandPrince};
constexpr std::array<const char*, 7> methodNames = {
    "explicit Euler", "semi-implicit Euler", "velocity Verlet", "midpoint", "Heun", "Runge-Kutta 4", "Dormand-Prince"};
inline const char* nameOf(Method method) {
    return methodNames[static_cast<std::size_t>(method)];
}

template <int N>
using Vector = Eigen::Matrix<double, N, 1>;
using Number = Vector<1>;

/// One step; the methods for first-order systems see position over velocity.
template <int N, typename Acceleration>
Phase<Vector<N>> stepOf(Method method, const Acceleration& acceleration, double time, const Phase<Vector<N>>& from,
                        double step) {
    if (method == Method::SemiImplicitEuler) return semiImplicitEulerStep(acceleration, time, from, step);
    if (method == Method::VelocityVerlet) return velocityVerletStep(acceleration, time, from, step);
    using Both = Vector<2 * N>;
    const auto slope = [&](double t, const Both& y) -> Both {
        const Vector<N> position = y.template head<N>(), velocity = y.template tail<N>();
        Both result;
        result.template head<N>() = velocity;
        result.template tail<N>() = acceleration(t, position, velocity);
        return result;
    };
    Both state;
    state.template head<N>() = from.position;
    state.template tail<N>() = from.velocity;
    if (method == Method::ExplicitEuler) state = explicitEulerStep(slope, time, state, step);
    if (method == Method::Midpoint) state = midpointStep(slope, time, state, step);
    if (method == Method::Heun) state = heunStep(slope, time, state, step);
    if (method == Method::RungeKutta4) state = rungeKutta4Step(slope, time, state, step);
    if (method == Method::DormandPrince) state = dormandPrinceStep(slope, time, state, slope(time, state), step).end;
    return {state.template head<N>(), state.template tail<N>()};
}

/// The same in the plane.
template <typename Acceleration>
Phase<Vec2> stepOf(Method method, const Acceleration& acceleration, double time, const Phase<Vec2>& from, double step) {
    const auto pull = [&](double t, const Vector<2>& x, const Vector<2>& v) -> Vector<2> {
        return acceleration(t, x, v);
    };
    const Phase<Vector<2>> after = stepOf<2>(method, pull, time, {from.position, from.velocity}, step);
    return {after.position, after.velocity};
}

/// x'' = -x.
inline Number oscillatorPull(double, const Number& x, const Number&) {
    return -x;
}

}  // namespace plumb::test
