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

constexpr int springSteps = 1000;   // on the oscillator, whose energy is watched
constexpr double springStep = 0.1;  // of 1 / w [s]

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
    int steps = 0;
    std::vector<Point> worst{};  ///< the largest relative error so far, about 200 points over the run
};

EnergyError energyErrorOf(const EnergyRun& run, const Method& method) {
    const double start = run.problem.energy(run.problem.start), every = run.endTime / 200;
    EnergyError error;
    double worst = 0, next = every;
    const auto see = [&](double time, const Motion& motion) {
        ++error.steps;
        worst = std::max(worst, std::fabs(run.problem.energy(motion) / start - 1));
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

/// Runs whose place at the end is held against the closed form.
struct ErrorRun {
    MotionProblem problem;
    double endTime = 0;  ///< [s]
    int fewest = 0;      ///< steps
    int doublings = 0;   ///< of the number of steps; a tenth of the tolerance each
};

/// The error at the end over the step: over the mean step, of the one that chooses its own. By rising step.
std::vector<Point> errorsOf(const ErrorRun& run, const Method& method) {
    const auto& [problem, endTime, fewest, doublings] = run;
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

constexpr double rounding = 1e-11;  // what lies below is of no method: up to 256,000 steps' rounding [m]
constexpr std::size_t fitted = 4;   // of the smallest steps, where the next power of the step matters least

double slopeOf(std::vector<Point> errors) {
    std::erase_if(errors, [](const Point& point) { return point.y < rounding; });
    errors.resize(std::min(errors.size(), fitted));
    return exponent(errors).value_or(std::nan(""));
}

void addEnergy(const std::string& title, const EnergyRun& run, LabRun& result) {
    Graph graph{.title = title, .x = {"periods", ""}, .y = {"largest relative energy error so far", "", true}};
    for (const Method& method : methods()) {
        const EnergyError error = energyErrorOf(run, method);
        const std::string note =
            method.step ? "" : fmt::format("{} steps at a tolerance of {:.0e}", error.steps, run.tolerance);
        graph.curves.push_back({.name = method.name, .points = error.worst, .note = note});
        result.values["energy." + run.problem.name + "." + method.tag] = error.worst.back().y;
    }
    result.graphs.push_back(graph);
}

void addErrors(const std::string& title, const ErrorRun& run, LabRun& result) {
    Graph graph{.title = title, .x = {"step", "s", true}, .y = {"distance from the closed form", "m", true}};
    std::vector<std::string> words;
    for (const Method& method : methods()) {
        const std::vector<Point> errors = errorsOf(run, method);
        const double slope = slopeOf(errors);
        const std::string note = fmt::format("slope {:.2f}", slope);
        graph.curves.push_back({.name = method.name, .points = errors, .note = note});
        result.values["order." + run.problem.name + "." + method.tag] = std::fabs(slope - method.order);
        words.push_back(fmt::format("{} {:.2f}", method.name, slope));
    }
    result.graphs.push_back(graph);
    result.seen.push_back(fmt::format("The error on the {} falls with the step to the power of: {}.", run.problem.name,
                                      fmt::join(words, ", ")));
}

void tellEnergies(LabRun& result) {
    const auto energy = [&](const std::string& of) { return result.values.at("energy." + of); };
    result.seen.push_back(
        fmt::format("After {} steps of {} / w explicit Euler's oscillator has {:.0f} times its energy, and no smaller "
                    "step keeps it from growing; semi-implicit Euler's stays within {:.1f} %, velocity Verlet's within "
                    "{:.2f} %, for ever. Midpoint's is {:.1f} % too much and rising, RK4's {:.4f} % too little and "
                    "falling.",
                    springSteps, springStep, energy("oscillator.explicit_euler") + 1,
                    100 * energy("oscillator.semi_implicit_euler"), 100 * energy("oscillator.velocity_verlet"),
                    100 * energy("oscillator.midpoint"), 100 * energy("oscillator.rk4")));
    result.seen.push_back(fmt::format(
        "On ten turns of an orbit of e = 0.5 the largest error of energy is {:.2g} of it for explicit "
        "Euler, {:.2g} for semi-implicit Euler, {:.2g} for velocity Verlet, {:.2g} for midpoint, {:.2g} "
        "for RK4, {:.2g} for Dormand-Prince.",
        energy("orbit.explicit_euler"), energy("orbit.semi_implicit_euler"), energy("orbit.velocity_verlet"),
        energy("orbit.midpoint"), energy("orbit.rk4"), energy("orbit.dormand_prince")));
    const double known = std::pow(1 + springStep * springStep, springSteps);
    result.values["energy.oscillator.explicit_euler.off"] =
        std::fabs((energy("oscillator.explicit_euler") + 1) / known - 1);
}

LabRun runIntegrators(const std::vector<Engine>&) {
    LabRun result;
    const MotionProblem spring = oscillator(), orbit = keplerOrbit(0.5);
    addEnergy("Oscillator, 1,000 steps of 0.1 / w: energy", {spring, springSteps * springStep, springSteps}, result);
    addEnergy("Orbit of e = 0.5, 1,000 steps a turn: energy", {orbit, 10 * orbit.period, 10000}, result);
    tellEnergies(result);
    // Not after whole periods: there the semi-implicit method's error is of second order.
    addErrors("Oscillator after 10 s: error", {spring, 10, 100, 8}, result);
    addErrors("Orbit after 1.3 turns: error", {orbit, 1.3 * orbit.period, 250, 10}, result);
    return result;
}

LabCheck energyCheck(const std::string& of, double limit, const std::string& reason) {
    return {.name = "energy.oscillator." + of, .limit = limit, .reason = reason};
}

std::vector<LabCheck> checks() {
    const double z = springStep, roundedUp = 1 + 1e-9;
    std::vector<LabCheck> result{
        energyCheck("explicit_euler.off", 1e-10, "each step multiplies it by 1 + z^2, z = h w; 1,000 roundings"),
        energyCheck("semi_implicit_euler", roundedUp * (z / 2) / (1 - z / 2),
                    "it stays below 1 / (1 - z / 2) of itself"),
        energyCheck("velocity_verlet", roundedUp * z * z / 4, "it stays above 1 - z^2 / 4 of itself"),
        energyCheck("midpoint", roundedUp * (std::pow(1 + z * z * z * z / 4, springSteps) - 1),
                    "each step multiplies it by 1 + z^4 / 4"),
        energyCheck("rk4", roundedUp * springSteps * std::pow(z, 6) / 72,
                    "each step multiplies it by 1 - z^6 / 72 + z^8 / 576"),
    };
    for (const std::string problem : {"oscillator", "orbit"})
        for (const Method& method : methods())
            result.push_back({.name = "order." + problem + "." + method.tag,
                              .limit = method.step ? 0.05 : 0.5,
                              .reason = method.step
                                            ? fmt::format("the slope is its order, {}; the next power of the step adds "
                                                          "a few hundredths",
                                                          method.order)
                                            : "the slope is 5, its order, if all steps shrink alike; the tolerance "
                                              "shrinks some more than others"});
    return result;
}

}  // namespace

Lab integrators() {
    return {.name = "integrators",
            .question = "What does each method of integration lose, and how fast does its error fall with the step?",
            .varied = "the step, and with Dormand-Prince the tolerance that chooses it",
            .checks = checks(),
            .run = runIntegrators};
}

}  // namespace plumb::compare
