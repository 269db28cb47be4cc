// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <compare/closed_form/oracle.h>
#include <compare/lab/builtin/labs.h>
#include <compare/lab/builtin/parts.h>
#include <compare/lab/graph.h>
#include <compare/metric/mechanics.h>
#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {
namespace {

constexpr std::array steps{1e-4, 2e-4, 5e-4, 1e-3, 2e-3, 5e-3, 1e-2};  // [s]
constexpr std::size_t fine = 3, coarse = 6;                            // the steps that are judged: 0.001 s and 0.01 s

struct Errors {
    double energy = 0;    ///< largest |E(t) - E(0)| [J]
    double distance = 0;  ///< largest distance from the closed form, if there is one [m]
};

double energyOf(const MassModel& masses, const std::vector<BodyState>& states) {
    const std::optional<Mechanics> sum = masses.at(states);
    return sum ? sum->kinetic + sum->lifted + sum->elastic : std::nan("");
}

double distanceFrom(const std::vector<BodyState>& truth, const std::vector<BodyState>& states) {
    double distance = 0;
    for (std::size_t i = 0; i < truth.size(); ++i)
        if (isFinite(truth[i])) distance = std::max(distance, (states[i].position - truth[i].position).norm());
    return distance;
}

/// The errors of a run with steps of dt. Once the energy's error is not a number, it stays so.
Errors errorsOf(Scene scene, const Engine& engine, double dt) {
    scene.dt = dt;
    if (scene.closedForm) scene.closedForm = workedOut(scene);
    const std::unique_ptr<Simulation> simulation = engine.build(scene);
    const MassModel masses(scene);
    const double start = energyOf(masses, simulation->states());
    Errors errors;
    const int count = stepCount(scene);
    for (int step = 1; step <= count && std::isfinite(errors.energy); ++step) {
        simulation->step(dt);
        const std::vector<BodyState> states = simulation->states();
        const double off = std::fabs(energyOf(masses, states) - start);
        errors.energy = std::isnan(off) ? off : std::max(errors.energy, off);
        if (scene.closedForm)
            errors.distance = std::max(errors.distance, distanceFrom(closedFormStates(scene, step * dt), states));
    }
    return errors;
}

/// The errors of one engine over the step.
struct Falls {
    std::vector<Point> energy{}, distance{};
};

Falls fallsOf(const Scene& scene, const Engine& engine) {
    Falls falls;
    for (const double dt : steps) {
        const Errors errors = errorsOf(scene, engine, dt);
        falls.energy.push_back({dt, errors.energy});
        falls.distance.push_back({dt, errors.distance});
    }
    return falls;
}

/// The slope between the two finest steps.
double finestOrder(const std::vector<Point>& points) {
    return exponent(std::span(points).first(2)).value_or(std::nan(""));
}

Curve curveOf(const Engine& engine, const std::vector<Point>& points) {
    return {.name = engine.name,
            .points = points,
            .note = fmt::format("slope {:.2f} at the finest steps", finestOrder(points))};
}

Graph graphOf(const std::string& title, const std::string& what, const std::string& unit) {
    return {.title = title, .x = {"step", "s", true}, .y = {what, unit, true}};
}

/// y = scale h^2.
Curve square(const std::string& name, double scale) {
    return {.name = name,
            .points = {{steps.front(), scale * steps.front() * steps.front()},
                       {steps.back(), scale * steps.back() * steps.back()}},
            .theory = true};
}

void runFourBar(const std::vector<Engine>& engines, LabRun& run) {
    Graph energy = graphOf("Double four-bar, 10 s: energy", "largest error of the energy", "J");
    for (const Engine& engine : engines) {
        const std::vector<Point> points = fallsOf(doubleFourBar(), engine).energy;
        energy.curves.push_back(curveOf(engine, points));
        run.values[engine.name + ".double_four_bar.energy.coarse"] = points[coarse].y;
        run.values[engine.name + ".double_four_bar.energy.fine"] = points[fine].y;
        run.seen.push_back(
            fmt::format("{}'s double four-bar is off by up to {:.2g} J at steps of 0.01 s, {:.2g} J at 0.001 s and "
                        "{:.2g} J at 0.0001 s; up to 70 J of it are kinetic.",
                        engine.label, points[coarse].y, points[fine].y, points.front().y));
    }
    energy.curves.push_back({.name = "published: generalised-alpha method",
                             .points = {{2.5e-4, 7.15e-5}, {1e-3, 1.14e-3}, {1e-2, 0.114}},
                             .theory = true});
    run.graphs.push_back(energy);
}

void runPendulum(const std::vector<Engine>& engines, LabRun& run) {
    Graph energy = graphOf("Pendulum from level, 10 s: energy", "largest error of the energy", "J");
    Graph distance = graphOf("Pendulum from level, 10 s: place", "largest distance from the closed form", "m");
    for (const Engine& engine : engines) {
        const Falls falls = fallsOf(pendulumHorizontal(), engine);
        energy.curves.push_back(curveOf(engine, falls.energy));
        distance.curves.push_back(curveOf(engine, falls.distance));
        run.values[engine.name + ".pendulum.order"] = finestOrder(falls.energy);
        run.seen.push_back(
            fmt::format("{}'s pendulum is off by up to {:.2g} J and {:.2g} m at steps of 0.001 s, {:.2g} J and "
                        "{:.2g} m at 0.0001 s.",
                        engine.label, falls.energy[fine].y, falls.distance[fine].y, falls.energy.front().y,
                        falls.distance.front().y));
    }
    const double published = 5e-5, at = 8e-4;
    energy.curves.push_back(square("second order through 5e-5 J at 0.8 ms", published / (at * at)));
    distance.curves.push_back(square("second order: 10 m/s^2 h^2", 10));
    run.graphs.push_back(energy);
    run.graphs.push_back(distance);
}

LabRun runConvergence(const std::vector<Engine>& engines) {
    LabRun run;
    runFourBar(engines, run);
    runPendulum(engines, run);
    return run;
}

std::vector<LabCheck> convergenceChecks() {
    const std::string& plumb = subjectName();
    return {{.name = plumb + ".double_four_bar.energy.coarse",
             .limit = 0.06,
             .unit = "J",
             .reason = "a step of 0.01 s; the generalised-alpha method, of second order, is published with 0.114 J",
             .engine = plumb},
            {.name = plumb + ".double_four_bar.energy.fine",
             .limit = 5e-4,
             .unit = "J",
             .reason = "a step of 0.001 s: a hundredth of 0.05 J at 0.01 s; published: 1.14e-3 J",
             .engine = plumb},
            {.name = plumb + ".pendulum.order",
             .bound = Bound::AtLeast,
             .limit = 1.9,
             .reason = "what hangs moves to second order: of the energy's error, at 0.0002 s and 0.0001 s",
             .engine = plumb}};
}

}  // namespace

Lab convergence(const std::function<Engine(const Engine&)>& oneStep) {
    return {.name = "convergence",
            .question = "How fast does the error of two known mechanisms fall with the step, in each engine?",
            .varied = "the step, from 0.01 s to 0.0001 s, solved in one part; double precision in Plumb alone",
            .checks = convergenceChecks(),
            .run = [oneStep](const std::vector<Engine>& engines) {
                std::vector<Engine> made;
                for (const Engine& engine : engines) made.push_back(oneStep(engine));
                return runConvergence(made);
            }};
}

}  // namespace plumb::compare
