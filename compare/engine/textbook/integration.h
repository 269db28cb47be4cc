// SPDX-License-Identifier: MIT
// Which methods of a textbook take a motion one step further?
#pragma once
#include <type_traits>

#include <Eigen/Core>

#include <plumb/integrate/fixed_step.h>
#include <plumb/integrate/symplectic.h>

namespace plumb::compare {

enum class Integration { ExplicitEuler, SemiImplicitEuler, VelocityVerlet, Midpoint, RungeKutta4 };

struct IntegrationName {
    Integration integration{};
    const char* name = "";  ///< for people: "explicit Euler"
    const char* tag = "";   ///< in the names of checks: "explicit_euler"
    int order = 1;
};

/// From the simplest to the most exact, in the order of Integration.
inline constexpr IntegrationName integrations[] = {
    {Integration::ExplicitEuler, "explicit Euler", "explicit_euler", 1},
    {Integration::SemiImplicitEuler, "semi-implicit Euler", "semi_implicit_euler", 1},
    {Integration::VelocityVerlet, "velocity Verlet", "velocity_verlet", 2},
    {Integration::Midpoint, "midpoint", "midpoint", 2},
    {Integration::RungeKutta4, "RK4", "rk4", 4},
};

/// Position and velocity in one vector, as methods for y' = f(y) take them.
template <EigenState State>
auto joined(const State& position, const State& velocity) {
    constexpr int size = State::SizeAtCompileTime;
    Eigen::Matrix<double, size == Eigen::Dynamic ? Eigen::Dynamic : 2 * size, 1> both(2 * position.size());
    both << position, velocity;
    return both;
}
template <EigenState State>
plumb::Phase<State> parted(const auto& both) {
    if constexpr (State::SizeAtCompileTime == Eigen::Dynamic)
        return {both.head(both.size() / 2), both.tail(both.size() / 2)};
    else
        return {both.template head<State::SizeAtCompileTime>(), both.template tail<State::SizeAtCompileTime>()};
}

/// The motion after a step of that length [s]. acceleration: called as State a(const State& position, const State&
/// velocity).
template <EigenState State, typename Acceleration>
plumb::Phase<State> integrated(Integration method, const Acceleration& acceleration, const plumb::Phase<State>& from,
                               double step) {
    const auto both = joined<State>(from.position, from.velocity);
    using Both = std::remove_const_t<decltype(both)>;
    const auto timed = [&](double, const State& x, const State& v) -> State { return acceleration(x, v); };
    const auto slope = [&](double, const Both& at) -> Both {
        const plumb::Phase<State> motion = parted<State>(at);
        return joined<State>(motion.velocity, acceleration(motion.position, motion.velocity));
    };
    switch (method) {
        case Integration::ExplicitEuler: return parted<State>(explicitEulerStep(slope, 0, both, step));
        case Integration::SemiImplicitEuler: return semiImplicitEulerStep(timed, 0, from, step);
        case Integration::VelocityVerlet: return velocityVerletStep(timed, 0, from, step);
        case Integration::Midpoint: return parted<State>(midpointStep(slope, 0, both, step));
        case Integration::RungeKutta4: break;
    }
    return parted<State>(rungeKutta4Step(slope, 0, both, step));
}

}  // namespace plumb::compare
