// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <compare/lab/builtin/labs.h>
#include <compare/lab/builtin/orbits.h>
#include <compare/lab/power_law.h>
#include <plumb/integrate/adaptive_walk.h>
#include <plumb/integrate/fixed_step.h>

namespace plumb::compare {
namespace {

using FlatMotion = Eigen::Vector4d;

FlatMotion flat(const Motion& motion) {
    FlatMotion state;
    state << motion.position, motion.velocity;
    return state;
}

Motion motionOf(const FlatMotion& state) {
    return {state.head<2>(), state.tail<2>()};
}

/// x' = v, v' = a(x): what methods of first order equations take.
auto derivativeOf(const MotionProblem& problem) {
    return [&problem](double, const FlatMotion& state) -> FlatMotion {
        FlatMotion slope;
        slope << state.tail<2>(), problem.acceleration(state.head<2>());
        return slope;
    };
}

struct Method {
    std::string name;
    std::string tag;  ///< in the names of checks
    int order = 1;
    std::function<Motion(const MotionProblem&, const Motion&, double)> step;  ///< empty: steps as long as it likes
};

std::vector<Method> methods() {
    const auto firstOrder = [](auto step) {
        return [step](const MotionProblem& problem, const Motion& from, double h) {
            return motionOf(step(derivativeOf(problem), 0, flat(from), h));
        };
    };
    const auto secondOrder = [](auto step) {
        return [step](const MotionProblem& problem, const Motion& from, double h) {
            const auto acceleration = [&](double, const Vec2& position, const Vec2&) {
                return problem.acceleration(position);
            };
            return step(acceleration, 0, from, h);
        };
    };
    const auto euler = [](const auto& f, double t, const auto& y, double h) { return explicitEulerStep(f, t, y, h); };
    const auto midpoint = [](const auto& f, double t, const auto& y, double h) { return midpointStep(f, t, y, h); };
    const auto rk4 = [](const auto& f, double t, const auto& y, double h) { return rungeKutta4Step(f, t, y, h); };
    const auto semi = [](const auto& a, double t, const Motion& y, double h) {
        return semiImplicitEulerStep(a, t, y, h);
    };
    const auto verlet = [](const auto& a, double t, const Motion& y, double h) {
        return velocityVerletStep(a, t, y, h);
    };
    return {{"explicit Euler", "explicit_euler", 1, firstOrder(euler)},
            {"semi-implicit Euler", "semi_implicit_euler", 1, secondOrder(semi)},
            {"velocity Verlet", "velocity_verlet", 2, secondOrder(verlet)},
            {"midpoint", "midpoint", 2, firstOrder(midpoint)},
            {"RK4", "rk4", 4, firstOrder(rk4)},
            {"Dormand-Prince, adaptive", "dormand_prince", 5, {}}};
}

/// Calls seen(time, motion) after each step, and returns how many there were.
template <typename Seen>
int walkAdaptively(const MotionProblem& problem, double endTime, double tolerance, const Seen& seen) {
    const AdaptiveSettings settings{.absoluteTolerance = tolerance, .relativeTolerance = tolerance};
    AdaptiveWalk walk(derivativeOf(problem), 0, flat(problem.start), endTime, settings);
    while (walk.advance()) seen(walk.time(), motionOf(walk.lastStep().end));
    return walk.accepted();
}

template <typename Seen>
void walkEvenly(const MotionProblem& problem, const Method& method, double endTime, int steps, const Seen& seen) {
    const double h = endTime / steps;
    Motion motion = problem.start;
    for (int i = 1; i <= steps; ++i) {
        motion = method.step(problem, motion, h);
        seen(i * h, motion);
    }
}

/// One run, whose energy is watched.
struct EnergyRun {
    MotionProblem problem;
    double endTime = 0;       ///< [s]
    int steps = 0;            ///< of the methods whose step is given
    double tolerance = 1e-9;  ///< of the one that chooses its own
};

struct EnergyError {
    std::vector<Point> worst{};  ///< the largest relative error so far, about 200 points over the run
    double atEnd = 0;            ///< energy over energy at the start, less 1 [-]
};

EnergyError energyErrorOf(const EnergyRun& run, const Method& method) {
    const double start = run.problem.energy(run.problem.start), every = run.endTime / 200;
    EnergyError error;
    double worst = 0, next = 0;
    const auto see = [&](double time, const Motion& motion) {
        error.atEnd = run.problem.energy(motion) / start - 1;
        worst = std::max(worst, std::fabs(error.atEnd));
        if (time < next) return;
        error.worst.push_back({time / run.problem.period, worst});
        next += every * std::max(1.0, std::ceil((time - next) / every));
    };
    if (method.step)
        walkEvenly(run.problem, method, run.endTime, run.steps, see);
    else
        walkAdaptively(run.problem, run.endTime, run.tolerance, see);
    return error;
}

double finalError(const MotionProblem& problem, const Motion& motion, double endTime) {
    return (motion.position - problem.truePosition(endTime)).norm();
}

constexpr double leastError = 1e-11, mostError = 0.1;  // of the points that a slope is fitted to [m]

/// The error at the end over the step: over the mean step, of the one that chooses its own.
std::vector<Point> errorsOf(const MotionProblem& problem, const Method& method, double endTime, int fewest,
                            int doublings) {
    std::vector<Point> errors;
    Motion last = problem.start;
    const auto keep = [&](double, const Motion& motion) { last = motion; };
    for (int i = 0; i <= doublings; ++i) {
        int steps = fewest << i;
        if (method.step)
            walkEvenly(problem, method, endTime, steps, keep);
        else
            steps = walkAdaptively(problem, endTime, std::pow(10, -3 - i), keep);
        errors.push_back({endTime / steps, finalError(problem, last, endTime)});
    }
    std::ranges::sort(errors, {}, &Point::x);
    return errors;
}

double slopeOf(const std::vector<Point>& errors) {
    std::vector<Point> fitted;
    for (const Point& point : errors)
        if (point.y >= leastError && point.y <= mostError) fitted.push_back(point);
    return exponent(fitted).value_or(std::nan(""));
}

void addEnergy(const std::string& title, const EnergyRun& run, LabRun& result) {
    Graph graph{.title = title, .x = {"periods", ""}, .y = {"largest energy error so far, of the whole", "", true}};
    std::vector<std::string> words;
    for (const Method& method : methods()) {
        const EnergyError error = energyErrorOf(run, method);
        graph.curves.push_back({.name = method.name, .points = error.worst});
        result.values["energy." + run.problem.name + "." + method.tag] = error.worst.back().y;
        words.push_back(fmt::format("{} {:.2e}", method.name, error.worst.back().y));
    }
    result.graphs.push_back(graph);
    result.seen.push_back(fmt::format("Largest energy error on the {} in {:.0f} periods: {}.", run.problem.name,
                                      run.endTime / run.problem.period, fmt::join(words, ", ")));
}

void addErrors(const std::string& title, const MotionProblem& problem, double endTime, int fewest, int doublings,
               LabRun& result) {
    Graph graph{.title = title, .x = {"step", "s", true}, .y = {"distance from the closed form", "m", true}};
    std::vector<std::string> words;
    for (const Method& method : methods()) {
        const std::vector<Point> errors = errorsOf(problem, method, endTime, fewest, doublings);
        const double slope = slopeOf(errors);
        const std::string note = fmt::format("slope {:.2f}", slope);
        graph.curves.push_back({.name = method.name, .points = errors, .note = note});
        result.values["order." + problem.name + "." + method.tag] = std::fabs(slope - method.order);
        words.push_back(fmt::format("{} {:.2f}", method.name, slope));
    }
    result.graphs.push_back(graph);
    result.seen.push_back(fmt::format("The error on the {} falls with the step to the power of: {}.", problem.name,
                                      fmt::join(words, ", ")));
}

LabRun runIntegrators(const std::vector<Engine>&) {
    LabRun result;
    const MotionProblem spring = oscillator(), orbit = keplerOrbit(0.5);
    addEnergy("Oscillator, 1,000 steps of 0.1 / w: energy", {spring, 100, 1000}, result);
    addEnergy("Orbit of e = 0.5, 1,000 steps a turn: energy", {orbit, 10 * orbit.period, 10000}, result);
    // Not a whole number of periods: there the semi-implicit method's error is of second order.
    addErrors("Oscillator after 10 s", spring, 10, 100, 8, result);
    addErrors("Orbit after 1.3 turns", orbit, 1.3 * orbit.period, 250, 10, result);
    return result;
}

}  // namespace

Lab integrators() {
    Lab lab{.name = "integrators",
            .question = "What does each method of integration lose, and how fast does its error fall with the step?",
            .varied = "the step",
            .run = runIntegrators};
    return lab;
}

}  // namespace plumb::compare
