// SPDX-License-Identifier: MIT
#include <compare/lab/builtin/methods.h>

#include <compare/engine/textbook/integration.h>
#include <plumb/integrate/adaptive_integrator.h>

namespace plumb::compare {
namespace {

/// x' = v, v' = a(x).
auto derivativeOf(const MotionProblem& problem) {
    return [&problem](double, const Eigen::Vector4d& state) -> Eigen::Vector4d {
        return joined<Vec2>(state.tail<2>(), problem.acceleration(state.head<2>()));
    };
}

Motion motionOf(const Eigen::Vector4d& state) {
    return {state.head<2>(), state.tail<2>()};
}

Method methodOf(const IntegrationName& known) {
    const auto step = [integration = known.integration](const MotionProblem& problem, const Motion& from, double dt) {
        const auto acceleration = [&](const Vec2& position, const Vec2&) { return problem.acceleration(position); };
        return integrated<Vec2>(integration, acceleration, from, dt);
    };
    return {known.name, known.tag, known.order, step};
}

}  // namespace

std::vector<Method> knownMethods() {
    std::vector<Method> methods;
    for (const IntegrationName& known : integrations) methods.push_back(methodOf(known));
    methods.push_back({"adaptive Dormand-Prince", "dormand_prince", 5, {}});
    return methods;
}

int walk(const Method& method, const MotionProblem& problem, double endTime, const Effort& effort,
         const std::function<void(double time, const Motion& motion)>& seen) {
    if (!method.step) {
        const Eigen::Vector4d start = joined<Vec2>(problem.start.position, problem.start.velocity);
        AdaptiveIntegrator adaptive(derivativeOf(problem), 0, start, endTime,
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
