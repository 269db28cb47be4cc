// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <compare/engine/engine.h>
#include <compare/metric/observation.h>
#include <compare/scene/builtin.h>
#include <compare/scene/set_field.h>
#include <plumb/math/random.h>

#include "catch.h"

namespace plumb::compare {
namespace {

const Engine& known(const std::string& name) {
    const Engine* engine = findKnown(name);
    REQUIRE(engine);
    return *engine;
}

/// A ball that falls freely for 2 s with g = 10 m/s^2, in steps of 0.1 s.
Scene fall() {
    return {.name = "fall",
            .gravity = {0, -10},
            .duration = 2,
            .dt = 0.1,
            .bodies = {{"ball", {.position = {0, 30}, .shapes = {circle(0.5)}}}}};
}

double endHeight(const Scene& scene, const std::string& engine) {
    return observe(scene, known(engine)).states.back().back().position.y();
}

/// A disc of 1 kg flies at a wall from 0 to 0.2 m, without gravity.
Scene shotAt(double speed, double start, const std::string& engine, int test) {
    Scene scene{.name = "shot",
                .gravity = {0, 0},
                .duration = 2,
                .dt = 0.1,
                .bodies = {{"wall", {.type = BodyType::Static, .shapes = {box({0.1, 5})}}},
                           {"ball",
                            {.position = {start, 0},
                             .velocity = {speed, 0},
                             .shapes = {circle(0.1, {.friction = 0, .restitution = 1})}}}}};
    scene.engines[engine]["solver.collisionTest"] = std::to_string(test);
    return scene;
}

double kinetic(const std::vector<BodyState>& states, const std::vector<double>& masses) {
    double sum = 0;
    for (std::size_t i = 0; i < states.size(); ++i) sum += masses[i] * states[i].velocity.squaredNorm() / 2;
    return sum;
}

}  // namespace

TEST_CASE("after 2 s at 10 m/s^2 in steps of 0.1 s explicit Euler is 1 m too high, semi-implicit 1 m too low",
          "[compare][engine][textbook]") {
    CHECK(endHeight(fall(), "explicit-euler") == Approx(30 - 20 + 1).epsilon(0).margin(1e-12));
    CHECK(endHeight(fall(), "semi-implicit-euler") == Approx(30 - 20 - 1).epsilon(0).margin(1e-12));
    for (const char* exact : {"velocity-verlet", "midpoint", "rk4"})
        CHECK(endHeight(fall(), exact) == Approx(10).epsilon(0).margin(1e-12));
}

TEST_CASE("a step of explicit Euler multiplies the energy of a spring by 1 + z^2, of RK4 by 1 - z^6/72 + z^8/576",
          "[compare][engine][textbook]") {
    // 1 kg on 4 N/m, pulled out by 1 m: w = 2 / s. In steps of 0.05 s z is 0.1.
    Scene scene{
        .name = "spring",
        .gravity = {0, 0},
        .duration = 5,
        .dt = 0.05,
        .bodies = {{"wall", {.type = BodyType::Static, .position = {-3, 0}, .shapes = {}}},
                   {"bob", {.position = {1, 0}, .mass = Mass{1, {0, 0}, 1}, .shapes = {circle(0.1)}}}},
        .joints = {{"spring", "wall", "bob",
                    DistanceJointDef{.anchorA = {-3, 0}, .anchorB = {1, 0}, .length = 3.0, .spring = Spring{4, 0}}}}};
    const auto growth = [&](const char* engine) {
        const std::vector<std::vector<BodyState>> states = observe(scene, known(engine)).states;
        const auto energy = [&](std::size_t tick) {
            const BodyState& bob = states[tick][1];
            return bob.velocity.squaredNorm() / 2 + 2 * bob.position.x() * bob.position.x();
        };
        return std::pow(energy(100) / energy(0), 0.01);
    };
    const double z2 = 0.01;
    CHECK(growth("explicit-euler") == Approx(1 + z2).epsilon(1e-12));
    CHECK(growth("midpoint") == Approx(1 + z2 * z2 / 4).epsilon(1e-12));
    CHECK(growth("rk4") == Approx(1 - std::pow(z2, 3) / 72 + std::pow(z2, 4) / 576).epsilon(1e-12));
}

TEST_CASE(
    "of 200 discs over 150 go through a wall by a test at the frame's end, fewer by bisection, none by a swept test",
    "[compare][engine][textbook]") {
    int through[3] = {0, 0, 0};
    Random random(25);
    for (int i = 0; i < 200; ++i) {
        const double speed = random.uniform(1, 100), start = -1 - random.uniform(0, speed * 0.1);
        for (int test = 0; test < 3; ++test) {
            const Scene scene = shotAt(speed, start, "semi-implicit-euler", test);
            const double end = observe(scene, known("semi-implicit-euler")).states.back()[1].position.x();
            through[test] += end > 0;
            // What hits without friction at e = 1 comes back as fast: as far from the wall as the way that is left.
            if (test == 2) CHECK(end == Approx(-0.2 - (2 * speed - (-0.2 - start))).epsilon(0).margin(1e-4));
        }
    }
    // What is found in the far half of the wall is moved out on the far side; bisection takes it back.
    CHECK(through[0] > 150);
    CHECK(through[1] > 100);
    CHECK(through[1] < through[0]);
    CHECK(through[2] == 0);
}

TEST_CASE("1,000 hits of two discs in a game's loop keep momentum, and at e = 1 their energy",
          "[compare][engine][textbook][law]") {
    Random random(7);
    int hits = 0;
    for (int i = 0; i < 1000; ++i) {
        Scene scene{.name = "two", .gravity = {0, 0}, .duration = 0.5, .dt = 0.05};
        const auto disc = [&](const char* name, double x, double vx) {
            const double density = random.uniform(0.5, 5);
            scene.bodies.push_back({name,
                                    {.position = {x, random.uniform(-0.3, 0.3)},
                                     .velocity = {vx, random.uniform(-1, 1)},
                                     .shapes = {circle(0.5, {.density = density, .friction = 0, .restitution = 1})}}});
        };
        disc("a", -1, random.uniform(1, 5));
        disc("b", 1, -random.uniform(1, 5));
        const char* engine = "velocity-verlet";
        scene.engines[engine]["solver.collisionTest"] = std::to_string(i % 3);
        const std::vector<std::vector<BodyState>> states = observe(scene, known(engine)).states;
        const std::vector<double> masses{massOf(scene.bodies[0].def).mass, massOf(scene.bodies[1].def).mass};
        const auto momentum = [&](std::size_t tick) -> Vec2 {
            return masses[0] * states[tick][0].velocity + masses[1] * states[tick][1].velocity;
        };
        hits += (states.back()[0].velocity - states.front()[0].velocity).norm() > 1e-9;
        CHECK((momentum(10) - momentum(0)).norm() < 1e-9);
        CHECK(kinetic(states.back(), masses) == Approx(kinetic(states.front(), masses)).epsilon(1e-9));
    }
    CHECK(hits > 900);
}

TEST_CASE(
    "bisection shows the slide's probes 0.5, 0.25, 0.375, 0.4375, 0.40625, and the swept test its t = 0.6267949192",
    "[compare][engine][textbook][slides]") {
    // It moves by 1 m in the frame of 0.1 s, and meets a wall from -0.5 m to 0.5 m after 0.41 m.
    Scene scene = shotAt(10, -1.01, "bisection", 0);
    scene.bodies[0].def.shapes = {box({0.5, 5})};
    scene.engines.clear();
    const std::vector<std::vector<BodyState>> states = observe(scene, known("bisection")).states;
    const double expected[] = {0, 1, 0.5, 0.25, 0.375, 0.4375, 0.40625, 0.40625};
    for (std::size_t tick = 0; tick < std::size(expected); ++tick)
        CHECK(states[tick][1].position.x() + 1.01 == Approx(expected[tick]).epsilon(0).margin(1e-12));

    Scene swept{.name = "swept",
                .gravity = {0, 0},
                .duration = 0.3,
                .dt = 0.1,
                .bodies = {{"target", {.type = BodyType::Static, .position = {8, 1}, .shapes = {circle(1)}}},
                           {"ball", {.velocity = {10, 0}, .shapes = {circle(1, {.friction = 0, .restitution = 1})}}}}};
    swept.engines["swept-test"]["solver.frame"] = "1";
    const std::vector<std::vector<BodyState>> stages = observe(swept, known("swept-test")).states;
    CHECK(stages[1][1].position.x() == Approx(6.267949192).epsilon(0).margin(2e-5));
    // The rest of the second, 0.3732050808, goes along the direction of the rebound.
    const double n[] = {std::sqrt(3) / 2, 0.5}, v[] = {10 - 2 * 10 * n[0] * n[0], -2 * 10 * n[0] * n[1]};
    CHECK(stages[2][1].position.x() == Approx(6.267949192 + 0.3732050808 * v[0]).epsilon(0).margin(1e-4));
    CHECK(stages[2][1].position.y() == Approx(0.3732050808 * v[1]).epsilon(0).margin(1e-4));
}

TEST_CASE("a display of 24 Hz shows a step a frame, and by a fixed clock every display comes to the same place",
          "[compare][engine][textbook]") {
    Scene scene = fall();
    scene.duration = 3;
    scene.dt = 1.0 / 240;
    // Semi-implicit Euler at 24 steps a second falls a h t / 2 too far.
    scene.engines["game-loop"]["solver.framesPerSecond"] = "24";
    CHECK(endHeight(scene, "game-loop") == Approx(30 - 45 - 10 * 3 / 24.0 / 2).epsilon(0).margin(1e-9));
    for (const char* rate : {"12", "24", "30", "60", "75", "144"}) {
        scene.engines["fixed-clock"]["solver.framesPerSecond"] = rate;
        scene.engines["fixed-clock"]["solver.interpolated"] = "0";
        INFO(rate);
        CHECK(endHeight(scene, "fixed-clock") == Approx(30 - 45).epsilon(0).margin(1e-9));
    }
    // Between the last two ticks: one tick of 0.02 s behind.
    scene.engines["fixed-clock"]["solver.interpolated"] = "1";
    CHECK(endHeight(scene, "fixed-clock") == Approx(30 - 5 * 2.98 * 2.98).epsilon(0).margin(1e-9));
}

TEST_CASE(
    "uneven frames are the same in each run, last as long in the mean, and end the scene within a frame of its end",
    "[compare][engine][textbook]") {
    Scene scene = fall();
    scene.dt = 1.0 / 500;
    scene.engines["plumb-frames"] = {{"solver.framesPerSecond", "50"}, {"solver.unevenness", "0.8"}};
    const Observation run = observe(scene, known("plumb-frames")), again = observe(scene, known("plumb-frames"));
    int frames = 0;
    for (std::size_t tick = 1; tick < run.states.size(); ++tick)
        frames += run.states[tick][0].position.y() != run.states[tick - 1][0].position.y();
    CHECK(std::abs(frames - 100) < 10);
    CHECK(run.states.back()[0].position == again.states.back()[0].position);
    // Plumb is where the formula says at the end of each frame: of the last one, up to 0.036 s ago.
    CHECK(run.states.back()[0].position.y() < 30 - 5 * 1.964 * 1.964);
    CHECK(run.states.back()[0].position.y() >= 30 - 20 - 1e-9);
}

TEST_CASE("what runs only if it is named is in no list of engines, and is there when it is named",
          "[compare][engine][textbook]") {
    CHECK(std::ranges::none_of(engines(), &Engine::onDemand));
    const std::vector<Engine> asked = enginesWith({"rk4", "plumb", "no such engine"});
    CHECK(asked.size() == engines().size() + 1);
    CHECK(std::ranges::count(asked, std::string("rk4"), &Engine::name) == 1);
}

TEST_CASE("a loop of a textbook says what it has not, by the name of the body", "[compare][engine][textbook][errors]") {
    const auto why = [](const std::string& scene) { return observe(*findScene(scene), known("rk4")).unsupported; };
    CHECK(why("maze_lap") == "a loop of a textbook has no movers");
    CHECK(why("pendulum_45") == "a loop of a textbook has no joints but springs");
    Scene tiled = fall();
    tiled.bodies.push_back({"ground", {.type = BodyType::Static, .shapes = {tiles(tileMapOf({"##"}, 1))}}});
    CHECK(observe(tiled, known("rk4")).unsupported == "a loop of a textbook has no tile maps: ground");
    CHECK(why("wrap_head_on") == "a loop of a textbook has no edges where the world goes on at the other side");
    CHECK(why("free_fall").empty());
}

}  // namespace plumb::compare
