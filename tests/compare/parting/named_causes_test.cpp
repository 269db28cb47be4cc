// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <compare/engine/engine.h>
#include <compare/parting/parting.h>
#include <compare/scene/builtin.h>

#include "catch.h"

namespace plumb::compare {
namespace {

struct Told {
    Parting parting;
    std::string text;
};

/// How Plumb and another engine part in a scene, at a rate of steps [Hz].
Told toldOf(Scene scene, const std::string& other, double rate) {
    scene.dt = 1 / rate;
    const auto runIn = [&](const std::string& name) {
        return observe(scene, *std::ranges::find(engines(), name, &Engine::name));
    };
    const Observation a = runIn("plumb"), b = runIn(other);
    const Observation* runs[] = {&a, &b};
    std::vector<Parting> partings = partingsOf(scene, runs);
    addPortions(scene, runs, partings);
    return {partings.at(0), partingText(scene, partings.at(0))};
}

bool says(const Told& told, const std::string& words) {
    return told.text.find(words) != std::string::npos;
}

double shareOf(const Told& told, Agent agent) {
    double share = 0;
    for (const Portion& portion : told.parting.portions)
        if (portion.agent == agent) share += portion.share;
    return share;
}

/// A car with two wheels, above a chain that is solid from below in an engine with one-sided chains.
Scene carOnChain(double length, double height) {
    Scene scene{.name = "car_on_chain", .duration = 2};
    scene.bodies = {
        {"ground", {.type = BodyType::Static, .shapes = {chain({{-20, 0}, {-5, 0}, {0, 0}, {5, 0}, {20, 0}})}}},
        {"chassis", {.position = {0, height + 0.4}, .shapes = {box({length / 2, 0.2})}}}};
    for (const double side : {-1.0, 1.0}) {
        const std::string name = side < 0 ? "rear" : "front";
        const Vec2 axle(side * length / 3, height);
        scene.bodies.push_back({name, {.position = axle, .shapes = {circle(0.3)}}});
        scene.joints.push_back({name + "_axle", "chassis", name, RevoluteJointDef{.anchor = axle}});
    }
    return scene;
}

constexpr double rates[] = {60, 240};

}  // namespace

TEST_CASE("a car whose wheels fall through the open side of a chain passed it, and the sentence says why",
          "[compare][parting]") {
    for (const double rate : rates)
        for (const double length : {1.5, 3.0})
            for (const double height : {0.31, 0.5, 1.5}) {
                const Told told = toldOf(carOnChain(length, height), "box2d-2.4", rate);
                INFO(rate << " Hz, " << length << " m long, from " << height << " m: " << told.text);
                CHECK(differenceName(told.parting.quantity) == "passed");
                CHECK(says(told, "goes through ground in box2d-2.4, and not in plumb (in box2d-2.4 a chain is solid"));
            }
}

TEST_CASE("a block that slides is behind by the order of the integration, and beside it by the skin",
          "[compare][parting]") {
    for (const double rate : rates) {
        const Told told = toldOf(*findScene("block_slides"), "box2d-2.4", rate);
        INFO(told.text);
        // Velocity first, then place: after a time T the place is off by a T dt / 2.
        const double slope = std::acos(-1) / 6, a = 9.81 * (std::sin(slope) - 0.3 * std::cos(slope));
        const double behind = a * 2 / (2 * rate), skin = 0.015;
        const double share = behind * behind / (behind * behind + skin * skin);
        CHECK(shareOf(told, Agent::Steps) == Approx(share).margin(0.03));
        CHECK(shareOf(told, Agent::Across) == Approx(1 - share).margin(0.03));
        CHECK(says(told, "(what touches is kept 14."));
    }
}

TEST_CASE("who is late on the same path is told by how much, and not that nobody is off", "[compare][parting]") {
    for (const double rate : rates) {
        const Scene atwood = *findScene("atwood_machine");
        const Told told = toldOf(atwood, "box2d-2.4", rate);
        INFO(told.text);
        CHECK(told.parting.body.empty());
        // 3 kg and 2 kg: a = g / 5; the place is off by a T dt / 2.
        CHECK(told.parting.late.distance == Approx(9.81 / 5 * atwood.duration / (2 * rate)).epsilon(0.02));
        CHECK(says(told, "stay together: in plumb light is late by at most one step ("));
    }
}

TEST_CASE("the skin of an engine is named where it alone is the cause", "[compare][parting]") {
    for (const double rate : rates) {
        const Told told = toldOf(*findScene("box_at_rest"), "box2d-2.4", rate);
        INFO(told.text);
        CHECK(isSkin(told.parting));
        CHECK(says(told, "(what touches is kept 14."));
        CHECK(says(told, " mm apart in box2d-2.4)"));
        CHECK(shareOf(told, Agent::Across) == Approx(1).margin(0.01));
    }
}

TEST_CASE("nothing bounces back at a share of its speed where restitution is 0", "[compare][parting]") {
    for (const double rate : rates)
        for (const char* name : {"ragdoll", "breaking_bridge", "rope_heaps_up", "car_over_hills", "stack_of_ten"})
            for (const char* other : {"box2d-2.4", "chipmunk"}) {
                Scene scene = *findScene(name);
                for (SceneBody& body : scene.bodies)
                    for (ShapeDef& shape : body.def.shapes) shape.material.restitution = 0;
                const Told told = toldOf(scene, other, rate);
                INFO(name << " at " << rate << " Hz: " << told.text);
                CHECK_FALSE(says(told, "bounces back"));
            }
}

TEST_CASE("where joints hold a body and no cause is known, the sentence says that none was found",
          "[compare][parting]") {
    for (const double rate : rates) {
        const Told told = toldOf(*findScene("springs_damped"), "box2d-2.4", rate);
        INFO(told.text);
        if (rate == 60) REQUIRE_FALSE(told.parting.body.empty());
        if (told.parting.body.empty()) continue;
        CHECK(says(told, "no cause was found; while the spring spring_of_swings holds it"));
        CHECK(shareOf(told, Agent::Joints) == Approx(1).margin(0.1));
    }
}

TEST_CASE("the same bounce within a step sooner is told as that", "[compare][parting]") {
    for (const double rate : rates) {
        const Told told = toldOf(*findScene("bounce_1"), "box2d-2.4", rate);
        INFO(told.text);
        REQUIRE_FALSE(told.parting.body.empty());
        CHECK(says(told, "up to a step sooner in one of the two, and then moves"));
    }
}

TEST_CASE("two that meet across the seam of a world are told to meet", "[compare][parting]") {
    for (const double rate : rates) {
        const Told told = toldOf(*findScene("wrap_head_on"), "box2d-2.4", rate);
        INFO(told.text);
        CHECK_FALSE(says(told, "nothing touches it"));
        CHECK((told.parting.at == "left, right" || told.parting.at == "right, left"));
        CHECK(shareOf(told, Agent::Across) == Approx(1).margin(0.05));
    }
}

TEST_CASE("a throw is off by the order of the integration alone", "[compare][parting]") {
    for (const double rate : rates)
        for (const char* other : {"box2d-2.4", "chipmunk"}) {
            const Told told = toldOf(*findScene("projectile"), other, rate);
            INFO(told.text);
            CHECK(differenceName(told.parting.quantity) == "steps");
            CHECK(shareOf(told, Agent::Steps) == Approx(1).margin(0.01));
        }
}

TEST_CASE("the parts of a distance sum to the whole", "[compare][parting]") {
    for (const char* name : {"block_slides", "head_on_1", "pendulum_150", "car_over_hills", "tile_floor", "ragdoll"}) {
        const Told told = toldOf(*findScene(name), "box2d-2.4", 60);
        double sum = 0;
        for (const Portion& portion : told.parting.portions) sum += portion.share;
        INFO(told.text);
        CHECK(sum == Approx(1).margin(0.05));
    }
}

}  // namespace plumb::compare
