// SPDX-License-Identifier: MIT
// Queries that are not about a run alone: aims, overlaps, tests of pairs, and numbers of the scene.
#include <compare/check/answer.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include <compare/metric/observation.h>
#include <compare/scene/answer.h>
#include <compare/scene/crowd.h>
#include <compare/scene/set_field.h>
#include <plumb/math/random.h>

#include "catch.h"
#include "numbers.h"

namespace plumb::compare {
namespace {

/// A ball at 20 m/s, and a target at (30, 5) that nothing hits.
Scene shooting() {
    return {.name = "shooting",
            .duration = 4,
            .bodies = {{"ball", {.velocity = {20, 0}, .shapes = {circle(0.1)}}},
                       {"target",
                        {.type = BodyType::Kinematic,
                         .position = {30, 5},
                         .shapes = {{.shape = Circle{.radius = 0.1}, .sensor = true}}}}}};
}

std::optional<double> read(const Scene& scene, const std::string& query) {
    Observation run;
    run.dt = scene.dt;
    std::vector<BodyState> states;
    for (const SceneBody& body : scene.bodies) states.push_back({body.def.position, body.def.angle, body.def.velocity});
    run.states = {states, states};
    return valueOf(scene, run, answerQuery(scene, query));
}

std::string complaint(const std::string& query) {
    try {
        (void)answerQuery(shooting(), query);
        return "";
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
}

}  // namespace

TEST_CASE("a shot of 20 m/s hits (30, 5) at 36.1765 and at 63.2858 degrees, and below 18.6389 m/s not at all",
          "[compare][check][shots]") {
    const Scene scene = shooting();
    CHECK(read(scene, "low angle of ball to target").value() == Approx(36.176477529).epsilon(1e-9));
    CHECK(read(scene, "high angle of ball to target").value() == Approx(63.285844679).epsilon(1e-9));
    CHECK(read(scene, "low time of ball to target").value() == Approx(1.8582692722).epsilon(1e-9));
    CHECK(read(scene, "high time of ball to target").value() == Approx(3.3367464652).epsilon(1e-9));
    CHECK(read(scene, "least speed of ball to target").value() == Approx(18.638924382).epsilon(1e-9));
    CHECK_FALSE(read(withField(scene, "bodies.ball.velocity", "18,0"), "low angle of ball to target"));
    CHECK(unitOf(scene, answerQuery(scene, "low angle of ball to target")) == "deg");
}

TEST_CASE(
    "a ball that is thrown as the aim says comes to the target, that moves or not, with drag or without, 300 times",
    "[compare][check][shots]") {
    Random random(16);
    int hits = 0;
    for (int i = 0; i < 300; ++i) {
        Scene scene = shooting();
        BodyDef &ball = scene.bodies[0].def, &target = scene.bodies[1].def;
        target.position = {random.uniform(5, 35), random.uniform(-5, 10)};
        if (i % 3 == 1) target.velocity = {random.uniform(-4, 4), random.uniform(-2, 2)};
        if (i % 3 == 2) ball.linearDamping = random.uniform(0.01, 0.3);
        const std::string arc = i % 2 == 0 ? "low" : "high";
        const auto angle = read(scene, arc + " angle of ball to target"),
                   time = read(scene, arc + " time of ball to target");
        if (!angle) continue;
        ++hits;
        ball.velocity = 20 * Vec2(std::cos(*angle * test::pi / 180), std::sin(*angle * test::pi / 180));
        scene.dt = *time / 100;
        scene.duration = *time;
        const Observation run = observe(scene, *findKnown("plumb"));
        CHECK((run.states.back()[0].position - run.states.back()[1].position).norm() < 1e-6);
    }
    CHECK(hits > 200);
}

TEST_CASE("a query reads the depth of an overlap, the tests of each broad phase, gravity and fields",
          "[compare][check]") {
    Scene scene = shooting();
    scene.bodies[0].def.shapes = {circle(1)};
    scene.bodies[1].def.shapes = {box({1, 1})};
    scene.bodies[1].def.position = {1.75, 0};
    CHECK(read(scene, "overlap of ball and target").value() == Approx(0.25).epsilon(1e-12));
    CHECK(read(scene, "overlap of target and ball at start").value() == Approx(0.25).epsilon(1e-12));
    CHECK(read(withField(scene, "bodies.target.position", "3,0"), "overlap of ball and target").value() == 0);
    CHECK(read(scene, "gravity").value() == 9.81);
    CHECK(read(scene, "field bodies.target.position.0").value() == 1.75);
    CHECK(read(scene, "field bodies.ball.shapes.0.circle.radius").value() == 1);
    const Scene crowd = crowdScene("even_100").value();
    CHECK(read(crowd, "tests by brute").value() == 4950);
    for (const char* way : {"grid", "sweep", "hierarchy"})
        CHECK(read(crowd, std::string("tests by ") + way).value() < 4950);
}

TEST_CASE("a query that is not understood is refused by what was wanted there", "[compare][check][errors]") {
    CHECK(complaint("low angel of ball to target").starts_with("answer: \"angel\" is not the name of angle or time"));
    CHECK(complaint("low angle of ball to targt")
              .starts_with("answer: \"targt\" is not the name of a body, the nearest "
                           "is target"));
    CHECK(complaint("tests by tree").starts_with("answer: \"tree\" is not the name of a broad phase"));
    CHECK(complaint("field bodies.ball.velocity") == "answer: bodies.ball.velocity: [20.0,0.0] is not a number");
    CHECK(complaint("field") == "answer: \"field\" ends too soon, wanted a field");
    CHECK(complaint("overlap of ball") == "answer: \"overlap of ball\" wants \"and\" there");
}

TEST_CASE("a crowd has as many boxes as its name says, from 2 to 5,000", "[compare][scene]") {
    CHECK(crowdScene("uneven_50").value().bodies.size() == 50);
    for (const char* name : {"even_", "even_1", "even_5001", "even_2x", "crowd_9"}) CHECK_FALSE(crowdScene(name));
}

}  // namespace plumb::compare
