// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <compare/check/verdict.h>
#include <compare/engine/engines.h>
#include <compare/parting/parting.h>
#include <compare/scene/builtin.h>

#include "catch.h"
#include "compare/scripted.h"

namespace plumb::compare {
namespace {

/// v t + g t^2 / 2, at the times.
OwnTrack parabolaAt(const std::vector<double>& times, const Vec2& velocity, const Vec2& gravity) {
    OwnTrack track{.file = "f.csv", .times = times};
    for (const double t : times) track.places.push_back(t * velocity + t * t / 2 * gravity);
    return track;
}

const std::vector<double> unevenTimes{0, 0.1, 0.11, 0.5, 0.9, 1.7, 1.8, 2.9, 3};

SceneResult shownBeside(const Scene& scene, const OwnTrack& track) {
    std::vector<Engine> shown = engines();
    shown.push_back(mineEngine(track));
    RunOptions options;
    options.inDetail = true;
    return runScene(scene, options, shown);
}

const EngineResult& mineOf(const SceneResult& result) {
    return result.engines.back();
}

double metricOf(const SceneResult& result, const char* name) {
    return mineOf(result).measured.metrics.at(name).value();
}

std::string buildComplaint(const Scene& scene, const OwnTrack& track) {
    try {
        mineEngine(track).build(scene);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "no complaint";
}

}  // namespace

TEST_CASE("a parabola sampled at 9 uneven times is the closed form of projectile within 1e-9 m",
          "[compare][engine][law]") {
    const Scene scene = *findScene("projectile");
    const Vec2 velocity = scene.bodies[0].def.velocity;
    const SceneResult result = shownBeside(scene, parabolaAt(unevenTimes, velocity, scene.gravity));
    CHECK(metricOf(result, "error_max") < 1e-9);
    CHECK(metricOf(result, "energy_drift") < 1e-9);
    CHECK(metricOf(result, "divergence_max") < 1e-9);
    CHECK(mineOf(result).answer == result.engines.front().answer);
    CHECK(result.verdict == Verdict::Holds);
    const BodyState last = mineOf(result).observation.states.back()[0];
    CHECK((last.velocity - (velocity + 3 * scene.gravity)).norm() < 1e-9);
}

TEST_CASE("a track by explicit Euler at 0.1 s is off by |a| h t / 2 at its rows: 0.5 m after 1 s at 10 m/s^2",
          "[compare][engine][law]") {
    // y of step n is v n h - g h^2 n (n - 1) / 2: the law's, and g h t / 2 above it.
    OwnTrack track{.file = "f.csv"};
    Vec2 place(0, 0), velocity(0, 3);
    const double h = 0.1, g = 10;
    for (int n = 0; n <= 10; ++n) {
        track.times.push_back(n * h);
        track.places.push_back(place);
        place += h * velocity;
        velocity.y() -= h * g;
    }
    const SceneResult result = shownBeside(oneDisc(), track);
    const std::vector<double>& error = mineOf(result).measured.series.error;
    REQUIRE(error.size() == 11);
    for (int n = 0; n <= 10; ++n) CHECK(std::abs(error[static_cast<std::size_t>(n)] - g * h * (n * h) / 2) < 1e-9);
    CHECK(std::abs(metricOf(result, "error_end") - 0.5) < 1e-9);
}

TEST_CASE("two rows are joined by a line, and outside of the rows there is no place", "[compare][engine]") {
    const OwnTrack track{.file = "f.csv", .times = {0.2, 0.6}, .places = {{1, 2}, {3, 4}}};
    const Observation run = observe(oneDisc(), mineEngine(track));
    CHECK(run.partial);
    CHECK(run.unsupported.empty());
    REQUIRE(run.states.size() == 11);
    for (std::size_t tick = 0; tick <= 10; ++tick)
        CHECK(run.states[tick][0].position.allFinite() == (tick >= 2 && tick <= 6));
    CHECK((run.states[3][0].position - Vec2(1.5, 2.5)).norm() < 1e-12);
    CHECK((run.states[3][0].velocity - Vec2(5, 5)).norm() < 1e-12);
}

TEST_CASE("a track that is shorter than the run has finite errors, and the parts of the answer that it reaches",
          "[compare][engine]") {
    const Scene scene = *findScene("projectile");
    OwnTrack track = parabolaAt({0.2, 0.9, 1.5, 2}, scene.bodies[0].def.velocity, scene.gravity);
    const SceneResult result = shownBeside(scene, track);
    CHECK(metricOf(result, "error_max") < 1e-9);
    CHECK(mineOf(result).answer == "It rises to 10.2 m at 1.44 s, and comes – far.");
    for (const auto& [name, value] : mineOf(result).measured.metrics) {
        INFO(name);
        CHECK((!value || std::isfinite(*value)));
    }
}

TEST_CASE("where a track leaves the path, only the speeds are told", "[compare][engine]") {
    const Scene scene = *findScene("projectile");
    const SceneResult result = shownBeside(scene, parabolaAt(unevenTimes, {14, 14}, scene.gravity));
    const auto parting = std::ranges::find_if(
        result.partings, [](const Parting& each) { return each.engineA == subjectName() && each.engineB == "mine"; });
    REQUIRE(parting != result.partings.end());
    CHECK(parting->quantity == Difference::Track);
    CHECK(parting->portions.empty());
    CHECK(std::abs(parting->apart - 3 * (scene.bodies[0].def.velocity - Vec2(14, 14)).norm()) < 1e-9);
    CHECK(partingText(scene, *parting).find(", and a track tells no cause. At the end it is 603 mm off.") !=
          std::string::npos);
}

TEST_CASE("of a body that turns, the angle is not known, and the places part all the same", "[compare][engine]") {
    const Scene scene = *findScene("spin_free");
    const SceneResult result = shownBeside(scene, parabolaAt(unevenTimes, {4, 8}, scene.gravity));
    const BodyState state = mineOf(result).observation.states[30][0];
    CHECK(state.position.allFinite());
    CHECK(std::isnan(state.angle));
    CHECK_FALSE(mineOf(result).measured.metrics.at("energy_drift"));
    CHECK_FALSE(mineOf(result).measured.metrics.at("probe.angle"));
    CHECK(std::abs(metricOf(result, "error_end") - 2) < 1e-9);  // 1 m/s slower, for 2 s
    CHECK(std::ranges::any_of(result.partings, [](const Parting& each) { return each.quantity == Difference::Track; }));
}

TEST_CASE("a track is of the body that it names, else of the first dynamic one", "[compare][engine][errors]") {
    Scene scene = oneDisc();
    SceneBody floor, other = scene.bodies[0];
    floor.name = "floor";
    floor.def.type = BodyType::Static;
    other.name = "other";
    scene.bodies = {floor, scene.bodies[0], other};
    OwnTrack track = parabolaAt({0, 1}, {1, 0}, {0, 0});
    const auto knows = [&](std::size_t body) {
        return mineEngine(track).build(scene)->states()[body].velocity == Vec2(1, 0);
    };
    CHECK((knows(1) && !knows(2)));
    track.body = "other";
    CHECK((!knows(1) && knows(2)));
    track.body = "disk";
    CHECK(buildComplaint(scene, track) ==
          "f.csv: body: \"disk\" is not the name of a body that moves, the nearest is disc; known are disc, other");
    track.body = "floor";
    CHECK(buildComplaint(scene, track).starts_with("f.csv: body: \"floor\" is not the name of a body that moves"));
    track.body = "";
    scene.bodies = {floor};
    CHECK(buildComplaint(scene, track) == "f.csv: body: the scene has no dynamic body, wanted a scene with one");
}

TEST_CASE("a track of 5 to 6 s in a scene of 1 s is refused, and so is one between two steps",
          "[compare][engine][errors]") {
    CHECK(buildComplaint(oneDisc(), parabolaAt({5, 6}, {1, 0}, {0, 0})) ==
          "f.csv: no step of the scene, which runs for 1 s, is within the rows, from 5 to 6 s");
    CHECK(buildComplaint(oneDisc(), parabolaAt({0.31, 0.39}, {1, 0}, {0, 0})) ==
          "f.csv: no step of the scene, which runs for 1 s, is within the rows, from 0.31 to 0.39 s");
    CHECK(buildComplaint(oneDisc(), parabolaAt({-2, -1}, {1, 0}, {0, 0})) ==
          "f.csv: no step of the scene, which runs for 1 s, is within the rows, from -2 to -1 s");
    CHECK(buildComplaint(oneDisc(), parabolaAt({1, 2}, {1, 0}, {0, 0})) == "no complaint");
}

TEST_CASE("the engine of a track is known by its name, is in no list, and looks like no other", "[compare][engine]") {
    const Engine* mine = findKnown("mine");
    REQUIRE(mine != nullptr);
    CHECK(mine->role == Role::Guest);
    CHECK(observe(oneDisc(), *mine).unsupported == "there is no track");
    for (const Engine& engine : knownEngines()) {
        INFO(engine.name);
        CHECK(engine.name != mine->name);
        CHECK(engine.label != mine->label);
        CHECK(engine.look.onLight != mine->look.onLight);
        CHECK(engine.look.onDark != mine->look.onDark);
        CHECK(engine.look.dash != mine->look.dash);
    }
}

}  // namespace plumb::compare
