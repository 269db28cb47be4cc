// SPDX-License-Identifier: MIT
#include <plumb/record/forecast.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include <compare/engine/plumb_world.h>
#include <compare/lab/builtin/labs.h>
#include <compare/lab/builtin/parts.h>
#include <compare/metric/length_text.h>
#include <compare/scene/builtin/parts.h>

namespace plumb::compare {
namespace {

constexpr double shotStep = 1.0 / 60;  // [s]
constexpr int shotTicks = 180;         // 3 s
constexpr int ticksBefore = 90;        // 1.5 s: the boxes land, bounce, and fall asleep
constexpr double shownSpeed = 12;      // [m/s]
constexpr int shotSpeeds = 33;         // from 4 to 20 m/s
const Vec2 muzzle(-6, 2);

/// A room with a step, two loose boxes that fall on it, and a mill that turns. The walls run clockwise, because in some
/// engines chains are solid on one side only.
Scene room() {
    const Material lively{.restitution = 0.6};
    Scene scene{.name = "room", .question = "How does a shot fly?", .duration = shotTicks * shotStep, .dt = shotStep};
    scene.bodies = {
        {"walls",
         {.type = BodyType::Static,
          .shapes = {{.shape = Chain{{{-8, 6}, {8, 6}, {8, 1}, {2, 1}, {2, 0}, {-8, 0}}, true}, .material = lively}}}},
        {"mill",
         {.type = BodyType::Kinematic,
          .position = {0, 3},
          .angularVelocity = 1.5,
          .shapes = {box({1.2, 0.1}, lively)}}},
        {"box_low", {.position = {4, 1.5}, .shapes = {box({0.4, 0.4}, lively)}}},
        {"box_high", {.position = {4.1, 2.6}, .shapes = {box({0.4, 0.4}, lively)}}},
    };
    return scene;
}

BodyDef shotAt(double speed) {
    return {.position = muzzle,
            .velocity = speed * direction(degrees(35)),
            .shapes = {circle(0.2, {.density = 2, .restitution = 0.8})}};
}

/// Plumb's room after some time of use: with lasting contacts, impulses to start from, and sleeping bodies.
PlumbWorld roomInUse() {
    PlumbWorld made = plumbWorld(room());
    for (int tick = 0; tick < ticksBefore; ++tick) made.world.step(shotStep);
    return made;
}

std::vector<Vec2> foreseen(const Forecast& forecast) {
    std::vector<Vec2> path;
    for (const Transform& pose : forecast.poses) path.push_back(pose.position);
    return path;
}

/// How the shot flew.
struct Outcome {
    std::vector<Vec2> positions, velocities;  ///< at the start, and after each tick [m], [m/s]
    std::vector<ForecastHit> hits;            ///< only Plumb reports them
};

/// The shot is fired in a new room that was stepped again, not in a copy.
Outcome firedInPlumb(double speed) {
    PlumbWorld made = roomInUse();
    World& world = made.world;
    const BodyId shot = world.add(shotAt(speed));
    Outcome outcome;
    for (int tick = 0;; ++tick) {
        outcome.positions.push_back(world.body(shot).position());
        outcome.velocities.push_back(world.body(shot).velocity());
        if (tick == shotTicks) return outcome;
        world.step(shotStep);
        for (const ContactBegin& begin : world.contactBegins()) {
            if (begin.shapeB.body == shot)
                outcome.hits.push_back({tick + 1, begin.point, begin.normal, begin.approachSpeed, begin.shapeA});
            else if (begin.shapeA.body == shot)
                outcome.hits.push_back({tick + 1, begin.point, -begin.normal, begin.approachSpeed, begin.shapeB});
        }
    }
}

/// The engine starts from the room as Plumb left it, and the shot is fired there. From then on, the engine runs by
/// itself.
Outcome fired(double speed, const Engine& engine) {
    if (engine.role == Role::Subject) return firedInPlumb(speed);
    Scene scene = room();
    const PlumbWorld made = roomInUse();
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const BodyView now = std::as_const(made.world).body(made.bodies[i]);
        BodyDef& def = scene.bodies[i].def;
        def.position = now.position();
        def.angle = now.angle();
        def.velocity = now.velocity();
        def.angularVelocity = now.angularVelocity();
    }
    scene.bodies.push_back({"shot", shotAt(speed)});
    const std::unique_ptr<Simulation> simulation = engine.build(scene);
    Outcome outcome;
    for (int tick = 0; tick <= shotTicks; ++tick) {
        if (tick > 0) simulation->step(shotStep);
        outcome.positions.push_back(simulation->states().back().position);
        outcome.velocities.push_back(simulation->states().back().velocity);
    }
    return outcome;
}

bool sameBits(const Vec2& a, const Vec2& b) {
    return std::memcmp(a.data(), b.data(), sizeof(double) * 2) == 0;
}

/// True if the two are the same apart from the world that they are in.
bool sameShape(const ShapeId& a, const ShapeId& b) {
    return a.body.index == b.body.index && a.body.generation == b.body.generation && a.number == b.number;
}

bool sameHit(const ForecastHit& a, const ForecastHit& b) {
    return a.tick == b.tick && sameBits(a.point, b.point) && sameBits(a.normal, b.normal) &&
           std::memcmp(&a.approachSpeed, &b.approachSpeed, sizeof(double)) == 0 && sameShape(a.other, b.other);
}

/// The number of hits that only one of the two has, or that differ.
int hitsOff(const std::vector<ForecastHit>& forecast, const std::vector<ForecastHit>& outcome) {
    const std::size_t longer = std::max(forecast.size(), outcome.size());
    int off = 0;
    for (std::size_t i = 0; i < longer; ++i)
        off += i >= forecast.size() || i >= outcome.size() || !sameHit(forecast[i], outcome[i]);
    return off;
}

/// One coordinate over time.
std::vector<Point> overTime(const std::vector<Vec2>& path, int axis) {
    std::vector<Point> points;
    for (std::size_t tick = 0; tick < path.size(); ++tick)
        points.push_back({static_cast<double>(tick) * shotStep, path[tick][axis]});
    return points;
}

struct Comparison {
    std::vector<Point> apart;  ///< [s, m]
    double largest = 0;        ///< [m]
    int ticksOff = 0;          ///< ticks in which any bit of its place or velocity differs
};

Comparison compared(const Forecast& forecast, const Outcome& outcome) {
    Comparison result;
    for (std::size_t tick = 0; tick < outcome.positions.size(); ++tick) {
        const Vec2& foretold = forecast.poses.at(tick).position;
        const double apart = (foretold - outcome.positions[tick]).norm();
        result.apart.push_back({static_cast<double>(tick) * shotStep, apart});
        result.largest = std::max(result.largest, apart);
        const bool same = sameBits(foretold, outcome.positions[tick]) &&
                          sameBits(forecast.velocities.at(tick), outcome.velocities[tick]);
        result.ticksOff += same ? 0 : 1;
    }
    return result;
}

double speedAt(int i) {
    return 4 + 16.0 * i / (shotSpeeds - 1);
}

/// Compares the engine with the forecasts of all speeds, and adds its results to run.
void runEngine(const Engine& engine, const std::vector<Forecast>& forecasts, LabRun& run, Graph& apart, Graph& over) {
    Curve largest{engine.name, {}};
    const bool own = engine.role == Role::Subject;
    int off = 0, otherHits = 0;
    double worst = 0;
    for (int i = 0; i < shotSpeeds; ++i) {
        const Forecast& forecast = forecasts[static_cast<std::size_t>(i)];
        const Outcome outcome = fired(speedAt(i), engine);
        const Comparison c = compared(forecast, outcome);
        otherHits += hitsOff(forecast.hits, outcome.hits);
        largest.points.push_back({speedAt(i), c.largest});
        off += c.ticksOff;
        worst = std::max(worst, c.largest);
        if (speedAt(i) == shownSpeed) apart.curves.push_back({engine.name, c.apart});
    }
    over.curves.push_back(largest);
    if (own) {
        run.values["ticks_off"] = off;
        run.values["hits_off"] = otherHits;
    }
    run.seen.push_back(
        fmt::format("{}: of {} shots, each of {} ticks, {} ticks differ from Plumb's forecast in place or velocity{}; "
                    "the farthest lies {} away.",
                    engine.label, shotSpeeds, shotTicks, off, own ? fmt::format(", and {} hits", otherHits) : "",
                    lengthText(worst)));
}

LabRun runForecast(const Forecaster& foretell, const std::vector<Engine>& engines) {
    const PlumbWorld made = roomInUse();
    LabRun run;
    std::vector<Forecast> forecasts;
    std::size_t hits = 0;
    Graph across{.title = "The shot at 12 m/s: how far across", .x = {"time", "s"}, .y = {"x", "m"}, .curves = {}};
    Graph height{.title = "The same shot: how high", .x = {"time", "s"}, .y = {"y", "m"}, .curves = {}};
    const auto draw = [&](const std::string& name, const std::vector<Vec2>& path, bool theory) {
        across.curves.push_back({.name = name, .points = overTime(path, 0), .theory = theory});
        height.curves.push_back({.name = name, .points = overTime(path, 1), .theory = theory});
    };
    for (int i = 0; i < shotSpeeds; ++i) {
        forecasts.push_back(foretell(made.world, shotAt(speedAt(i)), shotTicks, shotStep));
        hits += forecasts.back().hits.size();
        if (speedAt(i) == shownSpeed) draw("forecast", foreseen(forecasts.back()), true);
    }
    for (const Engine& engine : engines) draw(engine.name, fired(shownSpeed, engine).positions, false);
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
        .question = "A shot is forecast with all its bounces, and then fired: does it fly as forecast?",
        .varied = "the shot's speed, from 4 to 20 m/s",
        .checks = {{.name = "ticks_off",
                    .reason = "the forecast is made in a copy of the world, and the copy computes the same bits, even "
                              "while boxes rest on each other or sleep",
                    .engine = subjectName()},
                   {.name = "hits_off",
                    .reason = "the same bits give the same hits: same shape, tick, point, direction and speed",
                    .engine = subjectName()},
                   {.name = "bounces",
                    .bound = Bound::AtLeast,
                    .limit = 3.0 * shotSpeeds,
                    .reason = "each shot meets walls, mill or boxes, on average at least three times"}},
        .run = [foretell](const std::vector<Engine>& engines) { return runForecast(foretell, engines); },
    };
}

}  // namespace plumb::compare
