// SPDX-License-Identifier: MIT
#include <compare/lab/builtin/methods.h>

#include <Eigen/Core>

#include <plumb/integrate/adaptive_integrator.h>
#include <plumb/integrate/fixed_step.h>

namespace plumb::compare {
namespace {

using FlatMotion = Eigen::Vector4d;

FlatMotion flat(const Motion& motion) {
    return {motion.position.x(), motion.position.y(), motion.velocity.x(), motion.velocity.y()};
}

Motion motionOf(const FlatMotion& state) {
    return {state.head<2>(), state.tail<2>()};
}

/// x' = v, v' = a(x).
auto derivativeOf(const MotionProblem& problem) {
    return [&problem](double, const FlatMotion& state) -> FlatMotion {
        return flat({state.tail<2>(), problem.acceleration(state.head<2>())});
    };
}

Motion eulerStep(const MotionProblem& problem, const Motion& from, double step) {
    return motionOf(explicitEulerStep(derivativeOf(problem), 0, flat(from), step));
}

Motion midpointMethodStep(const MotionProblem& problem, const Motion& from, double step) {
    return motionOf(midpointStep(derivativeOf(problem), 0, flat(from), step));
}

Motion rk4Step(const MotionProblem& problem, const Motion& from, double step) {
    return motionOf(rungeKutta4Step(derivativeOf(problem), 0, flat(from), step));
}

/// x'' = a(x).
auto accelerationOf(const MotionProblem& problem) {
    return [&problem](double, const Vec2& position, const Vec2&) { return problem.acceleration(position); };
}

Motion semiImplicitStep(const MotionProblem& problem, const Motion& from, double step) {
    return semiImplicitEulerStep(accelerationOf(problem), 0, from, step);
}

Motion verletStep(const MotionProblem& problem, const Motion& from, double step) {
    return velocityVerletStep(accelerationOf(problem), 0, from, step);
}

}  // namespace

std::vector<Method> knownMethods() {
    return {{"explicit Euler", "explicit_euler", 1, eulerStep},
            {"semi-implicit Euler", "semi_implicit_euler", 1, semiImplicitStep},
            {"velocity Verlet", "velocity_verlet", 2, verletStep},
            {"midpoint", "midpoint", 2, midpointMethodStep},
            {"RK4", "rk4", 4, rk4Step},
            {"adaptive Dormand-Prince", "dormand_prince", 5, {}}};
}

int walk(const Method& method, const MotionProblem& problem, double endTime, const Effort& effort,
         const std::function<void(double time, const Motion& motion)>& seen) {
    if (!method.step) {
        AdaptiveIntegrator adaptive(derivativeOf(problem), 0, flat(problem.start), endTime,
                                    {.absoluteTolerance = effort.tolerance, .relativeTolerance = effort.tolerance});
        while (adaptive.advance()) seen(adaptive.time(), motionOf(adaptive.lastStep().end));
        return adaptive.accepted();
    }
    const double step = endTime / effort.steps;
    Motion motion = problem.start;
    for (int i = 1; i <= effort.steps; ++i) {
        motion = method.step(problem, motion, step);
        seen(i * step, motion);
    }
    return effort.steps;
}

}  // namespace plumb::compare
