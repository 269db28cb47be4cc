// SPDX-License-Identifier: MIT
#include <compare/parting/parting.h>

#include <algorithm>

#include <compare/engine/engine.h>

#include "catch.h"
#include "compare/parting/planted.h"
#include "compare/scripted.h"

namespace plumb::compare {
namespace {

Observation runOf(const Scene& scene, const std::string& name) {
    return observe(scene, *std::ranges::find(engines(), name, &Engine::name));
}

Parting partingIn(const Scene& scene, const Observation& a, const Observation& b) {
    const Observation* runs[] = {&a, &b};
    return partingsOf(scene, runs).at(0);
}

/// A disc whose place is told by a function of time.
Observation told(const Scene& scene, const std::string& name, const std::function<Vec2(double)>& place) {
    const Engine engine = scripted(name, {[place](double t) {
                                       constexpr double h = 1e-6;
                                       BodyState state;
                                       state.position = place(t);
                                       state.velocity = (place(t + h) - place(t - h)) / (2 * h);
                                       return std::vector<BodyState>{state};
                                   }});
    return observe(scene, engine);
}

}  // namespace

TEST_CASE("where two engines part for a planted reason, the sentence names quantity, body and time",
          "[compare][parting]") {
    for (const Planted& planted : plantedScenes()) {
        validate(planted.scene);
        const Parting parting =
            partingIn(planted.scene, runOf(planted.scene, planted.engineA), runOf(planted.scene, planted.engineB));
        const std::string text = partingText(planted.scene, parting);
        INFO(planted.scene.name << ": " << text);
        CHECK(differenceName(parting.quantity) == differenceName(planted.quantity));
        CHECK(parting.body == planted.body);
        CHECK(parting.at.starts_with(planted.at));
        CHECK(parting.time >= planted.earliest);
        CHECK(parting.time <= planted.latest);
        CHECK(text.find(planted.body + " parts at ") != std::string::npos);
    }
}

TEST_CASE("at other steps the sentence names the same reason, if the reason is not the step itself",
          "[compare][parting]") {
    const std::vector<std::string> ofTheStep{"stretching_hinge",    "tunnelling",  "sinking_stack",
                                             "fewer_sub_steps",     "speed_limit", "spring_that_tires",
                                             "other_order_of_steps"};
    for (Planted planted : plantedScenes()) {
        if (std::ranges::find(ofTheStep, planted.scene.name) != ofTheStep.end()) continue;
        for (const double rate : {120.0, 240.0, 960.0}) {
            if (planted.scene.name == "steeper_ramp" && rate > 120) continue;  // the speed along it differs as much
            planted.scene.dt = 1 / rate;
            const Parting parting =
                partingIn(planted.scene, runOf(planted.scene, planted.engineA), runOf(planted.scene, planted.engineB));
            INFO(planted.scene.name << " at " << rate << " Hz: " << partingText(planted.scene, parting));
            CHECK(differenceName(parting.quantity) == differenceName(planted.quantity));
            CHECK(parting.body == planted.body);
            CHECK(parting.at.starts_with(planted.at));
        }
    }
}

TEST_CASE("after a first small parting, a second one says why a body is far away at the end", "[compare][parting]") {
    Scene scene = plantedScenes().at(7).scene;  // the puck's damping differs
    scene.duration = 4;
    scene.bodies.push_back({"shot", {.position = {-20, 5}, .velocity = {30, 0}, .shapes = {circle(0.2)}}});
    scene.bodies.push_back({"wall", {.type = BodyType::Static, .position = {0, 5}, .shapes = {box({0.5, 2})}}});
    scene.engines["box2d-2.4"]["bodies.wall.enabled"] = "false";
    const Observation a = runOf(scene, "plumb"), b = runOf(scene, "box2d-2.4");
    const Observation* runs[] = {&a, &b};
    const std::vector<Parting> partings = partingsOf(scene, runs);
    REQUIRE(partings.size() == 2);
    CHECK(partings[0].body == "puck");
    CHECK(partings[0].quantity == Difference::Flight);
    CHECK(partings[1].body == "shot");
    CHECK(partings[1].at == "shot, wall");
    CHECK(partings[1].limit > 5);
    CHECK(partings[1].time > partings[0].time);
}

TEST_CASE("what falls through a chain from its left in one engine only is told, and why", "[compare][parting]") {
    const Scene scene{
        .name = "wrong_side",
        .duration = 2,
        .bodies = {{"ground", {.type = BodyType::Static, .shapes = {chain({{-5, 0}, {-2, 0}, {2, 0}, {5, 0}})}}},
                   {"ball", {.position = {0, 2}, .shapes = {circle(0.5)}}}}};
    const Observation a = runOf(scene, "plumb"), b = runOf(scene, "box2d-2.4");
    const std::string text = partingText(scene, partingIn(scene, a, b));
    INFO(text);
    CHECK(text.find("it goes through ground in box2d-2.4, and not in plumb") != std::string::npos);
    CHECK(text.find(" (in box2d-2.4 a chain is solid only on the right of its direction).") != std::string::npos);
}

TEST_CASE("two speeds that are printed alike are told as one", "[compare][parting]") {
    const Parting parting{.engineA = "a",
                          .engineB = "b",
                          .body = "disc",
                          .limit = 0.01,
                          .quantity = Difference::Flight,
                          .at = "disc",
                          .valueA = 4.41401,
                          .valueB = 4.41399};
    CHECK(partingText(oneDisc(), parting).find(" it moves at 4.414 m/s in both by then.") != std::string::npos);
}

TEST_CASE("a speed that one run gains where the other loses it is not told as a negative loss", "[compare][parting]") {
    const Parting parting{.engineA = "a",
                          .engineB = "b",
                          .body = "disc",
                          .limit = 0.01,
                          .quantity = Difference::Snag,
                          .at = "disc, floor",
                          .valueA = -0.5,
                          .valueB = 2,
                          .when = 1};
    const std::string text = partingText(oneDisc(), parting);
    CHECK(text.find(": on floor it loses 2 m/s at once at 1 s in b, nothing in a.") != std::string::npos);
}

TEST_CASE("a joint that broke in one run only, and does not hold the body, is not why it parts", "[compare][parting]") {
    Scene scene = plantedScenes().at(7).scene;
    for (const double x : {10.0, 11.0}) {
        const std::string name = x == 10 ? "left" : "right";
        scene.bodies.push_back({name, {.position = {x, 10}, .shapes = {circle(0.4)}}});
    }
    scene.joints = {{"far_away", "left", "right", WeldJointDef{.anchor = {10.5, 10}}}};
    const Observation a = runOf(scene, "plumb");
    Observation b = runOf(scene, "box2d-2.4");
    b.brokenAt = {3};
    const Parting parting = partingIn(scene, a, b);
    CHECK(parting.body == "puck");
    CHECK(parting.quantity == Difference::Flight);
    scene.joints[0].bodyA = "puck";
    CHECK(partingIn(scene, a, b).quantity == Difference::Break);
}

TEST_CASE("two runs that are the same do not part, and are 0 m off", "[compare][parting]") {
    const Scene scene = oneDisc();
    const auto still = [](double) { return Vec2(0, 0); };
    const Parting parting = partingIn(scene, told(scene, "plumb", still), told(scene, "chipmunk", still));
    CHECK(parting.body.empty());
    CHECK(parting.apart == 0);
    CHECK(partingText(scene, parting) == "plumb and chipmunk stay together: no body is farther than 0 m off its path.");
}

TEST_CASE("who is late by a step, or less, is on the path, who is 2 cm beside it is not", "[compare][parting]") {
    const Scene scene = oneDisc();
    const auto ahead = [](double t) { return Vec2(3 * t, t * t); };
    const Observation first = told(scene, "plumb", ahead);
    const auto late = [&](double t) { return ahead(t - 0.05); };
    CHECK(partingIn(scene, first, told(scene, "chipmunk", late)).body.empty());
    const auto beside = [&](double t) { return Vec2(ahead(t) + Vec2(0, t >= 0.5 ? 0.02 : 0)); };
    const Parting parting = partingIn(scene, first, told(scene, "chipmunk", beside));
    CHECK(parting.body == "disc");
    CHECK(parting.time == 0.5);
}

TEST_CASE("a body that one engine loses parts there, and is infinitely far off", "[compare][parting]") {
    const Scene scene = oneDisc();
    const auto still = [](double) { return Vec2(0, 0); };
    const auto lost = [](double t) { return t < 0.35 ? Vec2(0, 0) : Vec2(nan, nan); };
    const Parting parting = partingIn(scene, told(scene, "plumb", still), told(scene, "chipmunk", lost));
    CHECK(parting.body == "disc");
    CHECK(parting.time > 0.35);
    CHECK(parting.time < 0.45);
    CHECK(std::isinf(parting.apart));
}

TEST_CASE("a field that is set for one engine alone changes nothing in the others", "[compare][parting][engine]") {
    Scene scene = plantedScenes().at(7).scene;
    Scene plain = scene;
    plain.engines.clear();
    const Observation with = runOf(scene, "plumb"), without = runOf(plain, "plumb");
    CHECK(with.hash == without.hash);
    const auto isTold = [](const Setting& setting) { return setting.first == "bodies.puck.linearDamping"; };
    CHECK(std::ranges::none_of(with.settings, isTold));
    CHECK(std::ranges::any_of(runOf(scene, "box2d-2.4").settings, isTold));
}

TEST_CASE("what is set for one engine and is not there, or has to be the same for all, is refused by its field",
          "[compare][engine][errors]") {
    const auto complaint = [](const std::string& path, const std::string& value) -> std::string {
        Scene scene = oneDisc();
        scene.engines["chipmunk"][path] = value;
        try {
            runOf(scene, "chipmunk");
            return "";
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
    };
    CHECK(complaint("bodies.dics.angle", "1").find("engines.chipmunk: bodies.dics.angle=1") == 0);
    CHECK(complaint("dt", "0.1").find("engines.chipmunk.dt: is the same for all engines") == 0);
    CHECK(complaint("solver.iteratoins", "1").find("engines.chipmunk.solver.iteratoins: ") == 0);
    CHECK(complaint("solver.iterations", "0") == "engines.chipmunk.solver.iterations: 0 is not from 1 to 1000");
}

}  // namespace plumb::compare
