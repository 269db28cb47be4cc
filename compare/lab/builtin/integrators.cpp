// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include <compare/lab/builtin/labs.h>
#include <compare/lab/graph.h>

namespace plumb::compare {
namespace {

using Methods = std::vector<Method>;

constexpr int springSteps = 1000;   // on the oscillator, to watch its energy
constexpr double springStep = 0.1;  // of 1 / w [s]

/// A run for which the energy error is recorded.
struct EnergyRun {
    MotionProblem problem;
    double endTime = 0;  ///< [s]
    Effort effort{};
};

struct EnergyError {
    int steps = 0;
    std::vector<Point> worst{};  ///< the largest relative error so far, at about 200 points of the run
};

EnergyError energyErrorOf(const EnergyRun& run, const Method& method) {
    const double start = run.problem.energy(run.problem.start), every = run.endTime / 200;
    EnergyError error;
    double worst = 0, next = every;
    error.steps = walk(method, run.problem, run.endTime, run.effort, [&](double time, const Motion& motion) {
        worst = std::max(worst, std::fabs(run.problem.energy(motion) / start - 1));
        if (time < next) return;
        error.worst.push_back({time / run.problem.period, worst});
        next += every * std::max(1.0, std::ceil((time - next) / every));
    });
    return error;
}

/// Runs whose final position is compared with the closed form.
struct ErrorRun {
    MotionProblem problem;
    double endTime = 0;  ///< [s]
    Effort first{};
    int count = 0;  ///< number of runs; each has twice the steps of the run before it, or a tenth of its tolerance
};

/// The final error over the step, or over the mean step if the method chooses its steps. Sorted by rising step.
std::vector<Point> errorsOf(const ErrorRun& run, const Method& method) {
    std::vector<Point> errors;
    const Vec2 truth = run.problem.truePosition(run.endTime);
    Effort effort = run.first;
    for (int i = 0; i < run.count; ++i) {
        Vec2 last = run.problem.start.position;
        const auto keep = [&](double, const Motion& motion) { last = motion.position; };
        const int steps = walk(method, run.problem, run.endTime, effort, keep);
        errors.push_back({run.endTime / steps, (last - truth).norm()});
        effort.steps *= 2;
        effort.tolerance /= 10;
    }
    std::ranges::sort(errors, {}, &Point::x);
    return errors;
}

constexpr double rounding = 1e-11;      // a smaller error is the rounding of up to 256,000 steps [m]
constexpr std::size_t fittedSteps = 4;  // the smallest steps, where the next power of the step matters least

double slopeOf(std::vector<Point> errors) {
    std::erase_if(errors, [](const Point& point) { return point.y < rounding; });
    errors.resize(std::min(errors.size(), fittedSteps));
    return exponent(errors).value_or(std::nan(""));
}

void addEnergy(const std::string& title, const EnergyRun& run, const Methods& methods, LabRun& result) {
    Graph graph{.title = title, .x = {"time", "periods"}, .y = {"largest relative energy error so far", "", true}};
    for (const Method& method : methods) {
        const EnergyError error = energyErrorOf(run, method);
        const std::string note = method.step ? "" : fmt::format("{} steps", error.steps);
        graph.curves.push_back({.name = method.name, .points = error.worst, .note = note});
        result.values["energy." + run.problem.name + "." + method.tag] = error.worst.back().y;
    }
    result.graphs.push_back(graph);
}

void addErrors(const std::string& title, const ErrorRun& run, const Methods& methods, LabRun& result) {
    Graph graph{.title = title, .x = {"step", "s", true}, .y = {"distance from the closed form", "m", true}};
    std::vector<std::string> words;
    for (const Method& method : methods) {
        const std::vector<Point> errors = errorsOf(run, method);
        const double slope = slopeOf(errors);
        graph.curves.push_back({.name = method.name, .points = errors, .note = fmt::format("slope {:.2f}", slope)});
        result.values["order." + run.problem.name + "." + method.tag] = std::fabs(slope - method.order);
        words.push_back(fmt::format("{:.2f} ({})", slope, method.name));
    }
    result.graphs.push_back(graph);
    result.seen.push_back(fmt::format("The error on the {} falls with the step to the power of {}.", run.problem.name,
                                      fmt::join(words, ", ")));
}

/// Says in words what the graphs of energy show.
std::string springSentence(const LabRun& result) {
    const auto percent = [&](const std::string& method) {
        return 100 * result.values.at("energy.oscillator." + method);
    };
    return fmt::format(
        "After {} steps of {} / w explicit Euler's oscillator has {:.0f} times its energy. Semi-implicit Euler's stays "
        "within {:.1f} % of it and velocity Verlet's within {:.2f} %, however long they run; midpoint's is {:.1f} % "
        "off "
        "by then and RK4's {:.4f} %, and both go on drifting.",
        springSteps, springStep, percent("explicit_euler") / 100 + 1, percent("semi_implicit_euler"),
        percent("velocity_verlet"), percent("midpoint"), percent("rk4"));
}

std::string orbitSentence(const Methods& methods, const LabRun& result) {
    std::vector<std::string> words;
    for (const Method& method : methods)
        words.push_back(fmt::format("{:.2g} ({})", result.values.at("energy.orbit." + method.tag), method.name));
    return fmt::format("On ten turns of the orbit the energy is off by up to {}, of the whole.",
                       fmt::join(words, ", "));
}

LabRun runIntegrators(const Methods& methods) {
    LabRun result;
    const MotionProblem spring = oscillator(), orbit = keplerOrbit(0.5);
    addEnergy("Oscillator, 1,000 steps of 0.1 / w: energy", {spring, springSteps * springStep, {springSteps}}, methods,
              result);
    addEnergy("Orbit of e = 0.5, 1,000 steps a turn: energy", {orbit, 10 * orbit.period, {10'000}}, methods, result);
    result.seen = {springSentence(result), orbitSentence(methods, result)};
    // The runs do not end after whole periods: there the semi-implicit method's error is of second order.
    addErrors("Oscillator after 10 s: error", {spring, 10, {100, 1e-3}, 9}, methods, result);
    addErrors("Orbit after 1.3 turns: error", {orbit, 1.3 * orbit.period, {250, 1e-3}, 11}, methods, result);
    const double known = std::pow(1 + springStep * springStep, springSteps);
    result.values["energy.oscillator.explicit_euler.off"] =
        std::fabs((result.values.at("energy.oscillator.explicit_euler") + 1) / known - 1);
    return result;
}

LabCheck energyCheck(const std::string& of, double limit, const std::string& reason) {
    return {.name = "energy.oscillator." + of, .limit = limit, .reason = reason};
}

LabCheck orderCheck(const std::string& problem, const Method& method) {
    LabCheck check{.name = "order." + problem + "." + method.tag, .limit = 0.05};
    check.reason = fmt::format(
        "how far the slope is from {}, the method's order: the next power of the step, and the "
        "rounding, bend it by some hundredths",
        method.order);
    if (!method.step) {
        check.limit = 0.5;
        check.reason =
            "how far the slope is from 5, the method's order: it would be 5 if a smaller tolerance made all "
            "steps shorter alike";
    }
    return check;
}

std::vector<LabCheck> checksFor(const Methods& methods) {
    const double z = springStep, roundedUp = 1 + 1e-9;
    std::vector<LabCheck> checks{
        energyCheck("explicit_euler.off", 1e-10,
                    "how far, relatively, it is from (1 + z^2)^1000 times its start, z = h w: 1,000 roundings"),
        energyCheck("semi_implicit_euler", roundedUp * (z / 2) / (1 - z / 2),
                    "it stays below 1 / (1 - z / 2) of its start"),
        energyCheck("velocity_verlet", roundedUp * z * z / 4, "it stays above 1 - z^2 / 4 of its start"),
        energyCheck("midpoint", roundedUp * (std::pow(1 + z * z * z * z / 4, springSteps) - 1),
                    "each step multiplies it by 1 + z^4 / 4"),
        energyCheck("rk4", roundedUp * springSteps * std::pow(z, 6) / 72,
                    "each step multiplies it by 1 - z^6 / 72 + z^8 / 576"),
    };
    for (const std::string problem : {"oscillator", "orbit"})
        for (const Method& method : methods) checks.push_back(orderCheck(problem, method));
    return checks;
}

}  // namespace

Lab integrators(const std::vector<Method>& methods) {
    return {.name = "integrators",
            .question = "What does each method of integration lose, and how fast does its error fall with the step?",
            .varied = "the step; of Dormand-Prince the tolerance, from which it chooses its steps",
            .checks = checksFor(methods),
            .run = [methods](const std::vector<Engine>&) { return runIntegrators(methods); }};
}

}  // namespace plumb::compare
