// SPDX-License-Identifier: MIT
#include <plumb/record/forecast.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include <compare/engine/plumb_world.h>
#include <compare/lab/builtin/labs.h>
#include <compare/lab/builtin/parts.h>
#include <compare/metric/length_text.h>
#include <compare/scene/builtin/parts.h>

namespace plumb::compare {
namespace {

constexpr double dt = 1.0 / 60;    // [s]
constexpr int ticks = 180;         // 3 s
constexpr double shownSpeed = 12;  // [m/s]
constexpr int speeds = 33;         // from 4 to 20 m/s
const Vec2 muzzle(-6, 2);

/// A room with a step, two loose boxes and a mill that turns. Clockwise: Box2D's chains are solid from one side only.
Scene room() {
    const Material lively{.restitution = 0.6};
    Scene scene{.name = "room", .question = "Where does a shot come to?", .duration = ticks * dt, .dt = dt};
    scene.bodies = {
        {"walls",
         {.type = BodyType::Static,
          .shapes = {{.shape = Chain{{{-8, 6}, {8, 6}, {8, 1}, {2, 1}, {2, 0}, {-8, 0}}, true}, .material = lively}}}},
        {"mill",
         {.type = BodyType::Kinematic,
          .position = {0, 3},
          .angularVelocity = 1.5,
          .shapes = {box({1.2, 0.1}, lively)}}},
        {"box_low", {.position = {4, 1.4}, .shapes = {box({0.4, 0.4}, lively)}}},
        {"box_high", {.position = {4.1, 2.2}, .shapes = {box({0.4, 0.4}, lively)}}},
    };
    return scene;
}

BodyDef shotAt(double speed) {
    return {.position = muzzle,
            .velocity = speed * direction(degrees(35)),
            .shapes = {circle(0.2, {.density = 2, .restitution = 0.8})}};
}

std::vector<Vec2> foreseen(const Forecast& forecast) {
    std::vector<Vec2> path;
    for (const Transform& pose : forecast.poses) path.push_back(pose.position);
    return path;
}

/// The shot is fired, and flies.
std::vector<Vec2> fired(double speed, const Engine& engine) {
    Scene scene = room();
    scene.bodies.push_back({"shot", shotAt(speed)});
    const std::unique_ptr<Simulation> simulation = engine.build(scene);
    std::vector<Vec2> path{simulation->states().back().position};
    for (int tick = 0; tick < ticks; ++tick) {
        simulation->step(dt);
        path.push_back(simulation->states().back().position);
    }
    return path;
}

bool sameBits(const Vec2& a, const Vec2& b) {
    return std::memcmp(a.data(), b.data(), sizeof(double) * 2) == 0;
}

/// One coordinate over time.
std::vector<Point> overTime(const std::vector<Vec2>& path, int axis) {
    std::vector<Point> points;
    for (std::size_t tick = 0; tick < path.size(); ++tick)
        points.push_back({static_cast<double>(tick) * dt, path[tick][axis]});
    return points;
}

struct Comparison {
    std::vector<Point> apart;  ///< [s, m]
    double largest = 0;        ///< [m]
    int ticksOff = 0;          ///< in which a bit differs
};

Comparison compared(const std::vector<Vec2>& forecast, const std::vector<Vec2>& outcome) {
    Comparison result;
    for (std::size_t tick = 0; tick < forecast.size(); ++tick) {
        const double apart = (forecast[tick] - outcome[tick]).norm();
        result.apart.push_back({static_cast<double>(tick) * dt, apart});
        result.largest = std::max(result.largest, apart);
        result.ticksOff += sameBits(forecast[tick], outcome[tick]) ? 0 : 1;
    }
    return result;
}

double speedAt(int i) {
    return 4 + 16.0 * i / (speeds - 1);
}

/// Over all speeds, and what that says of this engine.
void runEngine(const Engine& engine, const std::vector<Forecast>& forecasts, LabRun& run, Graph& apart, Graph& over) {
    Curve largest{engine.name, {}};
    int off = 0;
    double worst = 0;
    for (int i = 0; i < speeds; ++i) {
        const Comparison c = compared(foreseen(forecasts[static_cast<std::size_t>(i)]), fired(speedAt(i), engine));
        largest.points.push_back({speedAt(i), c.largest});
        off += c.ticksOff;
        worst = std::max(worst, c.largest);
        if (speedAt(i) == shownSpeed) apart.curves.push_back({engine.name, c.apart});
    }
    over.curves.push_back(largest);
    const bool own = engine.name == plumbName;
    if (own) run.values["ticks_off"] = off;
    run.seen.push_back(
        fmt::format("{}: of {} shots, each of {} ticks, {} ticks differ from Plumb's forecast; the "
                    "farthest lies {} away.",
                    engineLabel(engine.name), speeds, ticks, off, lengthText(worst)));
}

LabRun runForecast(const Forecaster& foretell, const std::vector<Engine>& engines) {
    const PlumbWorld made = plumbWorld(room());
    LabRun run;
    std::vector<Forecast> forecasts;
    std::size_t hits = 0;
    Graph across{.title = "The shot at 12 m/s: how far across", .x = {"time", "s"}, .y = {"x", "m"}, .curves = {}};
    Graph height{.title = "The same shot: how high", .x = {"time", "s"}, .y = {"y", "m"}, .curves = {}};
    const auto draw = [&](const std::string& name, const std::vector<Vec2>& path, bool theory) {
        across.curves.push_back({.name = name, .points = overTime(path, 0), .theory = theory});
        height.curves.push_back({.name = name, .points = overTime(path, 1), .theory = theory});
    };
    for (int i = 0; i < speeds; ++i) {
        forecasts.push_back(foretell(made.world, shotAt(speedAt(i)), ticks, dt));
        hits += forecasts.back().hits.size();
        if (speedAt(i) == shownSpeed) draw("forecast", foreseen(forecasts.back()), true);
    }
    for (const Engine& engine : engines) draw(engine.name, fired(shownSpeed, engine), false);
    Graph apart{.title = "The same shot: how far from its forecast", .x = {"time", "s"}, .y = {"distance", "m"}};
    Graph overSpeed{
        .title = "The farthest from the forecast in 3 s", .x = {"speed of the shot", "m/s"}, .y = {"distance", "m"}};
    for (const Engine& engine : engines) runEngine(engine, forecasts, run, apart, overSpeed);
    run.values["bounces"] = static_cast<double>(hits);
    run.graphs = {across, height, apart, overSpeed};
    return run;
}

}  // namespace

Forecast foretold(const World& world, const BodyDef& shot, int steps, double interval) {
    return forecast(world, shot, steps, interval);
}

Lab forecasts(const Forecaster& foretell) {
    return {
        .name = "forecast",
        .question = "A shot is forecast, bounces and all, and then fired: does it fly as was foretold?",
        .varied = "the shot's speed, from 4 to 20 m/s",
        .checks = {{.name = "ticks_off",
                    .reason = "the forecast is made in a copy of the world, which goes on to the same bits",
                    .engine = std::string(plumbName)},
                   {.name = "bounces",
                    .bound = Bound::AtLeast,
                    .limit = 3.0 * speeds,
                    .reason = "each shot meets walls, mill or boxes, three times at least in the mean"}},
        .run = [foretell](const std::vector<Engine>& engines) { return runForecast(foretell, engines); },
    };
}

}  // namespace plumb::compare
