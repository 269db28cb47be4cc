// SPDX-License-Identifier: MIT
#include <compare/report/data.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include <plumb/shapes/tile_text.h>
#include "catch.h"
#include "compare/scripted.h"
#include "unpacked.h"

namespace plumb::compare {
namespace {

using nlohmann::json;

json onlyScene(const SceneResult& result) {
    return reportData({result}).at("scenes").at(0);
}

SceneResult discBesideItsClosedForm() {
    Scene scene = oneDisc();
    scene.checks = {ExactCheck{0.001, "why not"}, AgreeCheck{0.02, 0.5, "until then"}};
    return runScene(scene, {}, {standing("plumb", 0.25), unsupporting("box2d-3"), standing("closed-form", 0)});
}

}  // namespace

TEST_CASE("the page knows the scene, its limits, each engine's states and curves, and what failed",
          "[compare][report]") {
    const json scene = onlyScene(discBesideItsClosedForm());
    CHECK(scene.at("name") == "one_disc");
    CHECK(scene.at("title") == "One disc");
    CHECK(scene.at("steps") == 10);
    CHECK(scene.at("changed").empty());
    CHECK(scene.at("limits") == json({{"error", 0.001}, {"divergence", 0.02}, {"agreeUntil", 0.5}}));
    CHECK(scene.at("bodies").at(0).at("shapes") == json::parse(R"([{"circle": [0, 0, 0.5]}])"));
    CHECK(scene.at("pass") == false);
    CHECK(scene.at("checks") == 2);
    CHECK(scene.at("outcomes").at(0).at("value") == 0.25);

    const json& plumb = scene.at("engines").at(0);
    CHECK(plumb.at("metrics").at("error_max") == 0.25);
    CHECK(plumb.at("metrics").at("joint_error_max").is_null());
    CHECK(plumb.at("divergence").is_null());
    const UnpackedBlock block(scene.at("packed").get<std::string>());
    CHECK(block.floats(plumb.at("error").at(0), 11) == std::vector<double>(11, 0.25));
    REQUIRE(plumb.at("states").at(1) == 33);
    CHECK(block.steps(plumb.at("states").at(0), 11, scene.at("lengthStep")) == std::vector<double>(11, 0.25));

    const json& box2d = scene.at("engines").at(1);
    CHECK(box2d.at("unsupported") == "it has no such thing");
    CHECK_FALSE(box2d.contains("states"));
}

TEST_CASE("the page knows of a scene without checks that it was not judged", "[compare][report]") {
    const json scene = onlyScene(runScene(oneDisc(), {}, {standing("plumb", 0)}));
    CHECK(scene.at("pass").is_null());
    CHECK(scene.at("checks") == 0);
}

TEST_CASE("each shape comes to the page by its points, and its radius where it has one", "[compare][report]") {
    Scene scene = oneDisc();
    scene.bodies[0].def.shapes = {
        capsule({-1, 0}, {1, 2}, 0.25), roundedBox({1, 0.5}, 0.125),     box({1, 0.5}),
        segment({0, 1}, {2, 3}),        chain({{4, 0}, {2, 1}, {0, 0}}), loop({{0, 0}, {0, 1}, {1, 0}})};
    const json shapes = onlyScene(runScene(scene, {}, {standing("plumb", 0)})).at("bodies").at(0).at("shapes");
    CHECK(shapes == json::parse(R"([{"capsule": [-1, 0, 1, 2], "radius": 0.25},
                                    {"polygon": [-1, -0.5, 1, -0.5, 1, 0.5, -1, 0.5], "radius": 0.125},
                                    {"polygon": [-1, -0.5, 1, -0.5, 1, 0.5, -1, 0.5]},
                                    {"segment": [0, 1, 2, 3]},
                                    {"chain": [4, 0, 2, 1, 0, 0]},
                                    {"chain": [0, 0, 0, 1, 1, 0, 0, 0]}])"));
}

TEST_CASE("of a tile map the page gets areas and outline, each with its kind of tiles", "[compare][report][tiles]") {
    Scene scene = oneDisc();
    scene.bodies[0].def.shapes = {tiles(tileMapOf({"^..=.~"}))};
    const json shapes = onlyScene(runScene(scene, {}, {standing("plumb", 0)})).at("bodies").at(0).at("shapes");
    CHECK(shapes == json::parse(R"([{"segment": [0, 0, 1, 0], "tiles": "hazard"},
                                    {"segment": [1, 0, 1, 1], "tiles": "hazard"},
                                    {"segment": [1, 1, 0, 1], "tiles": "hazard"},
                                    {"segment": [0, 1, 0, 0], "tiles": "hazard"},
                                    {"segment": [4, 1, 3, 1], "tiles": "oneWay"},
                                    {"polygon": [0, 0, 1, 0, 1, 1, 0, 1], "tiles": "hazard"},
                                    {"polygon": [5, 0, 6, 0, 6, 1, 5, 1], "tiles": "sensor"}])"));
}

TEST_CASE("a joint's ends are fixed to its bodies, turned as they stand at the start", "[compare][report]") {
    Scene scene = oneDisc();
    scene.closedForm.reset();
    scene.bodies.push_back(scene.bodies[0]);
    scene.bodies[1].name = "turned";
    scene.bodies[1].def.position = {2, 1};
    scene.bodies[1].def.angle = std::numbers::pi / 2;
    // One metre above the turned body: ahead of it along its own x.
    scene.joints = {{"rod", "disc", "turned", DistanceJointDef{.anchorA = {0.5, 0}, .anchorB = {2, 2}}},
                    {"pin", "disc", "turned", RevoluteJointDef{.anchor = {2, 2}}},
                    {"mouse", "disc", "", TargetJointDef{}},  // has no second body to be drawn to
                    {"axis", "disc", "turned", PrismaticJointDef{.anchor = {2, 2}}}};
    SceneResult result;
    result.scene = scene;
    const json joints = onlyScene(result).at("joints");
    CHECK(joints.at(0).at("type") == "distance");
    CHECK(joints.at(0).at("atA") == json({0.5, 0.0}));
    // Rounding of a quarter turn's cosine, at one metre.
    CHECK(std::abs(joints.at(0).at("atB").at(0).get<double>() - 1) < 1e-15);
    CHECK(std::abs(joints.at(0).at("atB").at(1).get<double>()) < 1e-15);
    CHECK(joints.at(1).at("type") == "revolute");
    CHECK(joints.at(1).at("atA") == json({2.0, 2.0}));
    CHECK(joints.size() == 3);
    CHECK(joints.at(2).at("type") == "prismatic");
}

TEST_CASE("a scene without closed form has no engine of that name in the page", "[compare][report]") {
    Scene scene = oneDisc();
    scene.closedForm.reset();
    const json data = onlyScene(runScene(scene, {}, {standing("plumb", 0), unsupporting("closed-form")}));
    CHECK(data.at("closedForm").is_null());
    CHECK(data.at("engines").size() == 1);
}

TEST_CASE("no text in the data can end the script it stands in, and all of it reads back", "[compare][report]") {
    Scene scene = oneDisc();
    scene.question = "Does </script><!-- <script> \"end\" \\ it?";
    SceneResult result;
    result.scene = scene;
    const json data = reportData({result});
    const std::string text = scriptText(data);
    CHECK(text.find('<') == std::string::npos);
    CHECK(json::parse(text) == data);
}

TEST_CASE("a setting that is not UTF-8 is shown with a mark in its place", "[compare][report]") {
    SceneResult result;
    result.scene = oneDisc();
    Observation run;
    run.engine = "plumb";
    run.unsupported = "bad \xFF byte";
    result.engines = {{run, {}}};
    const json read = json::parse(scriptText(reportData({result})));
    CHECK(read.at("scenes").at(0).at("engines").at(0).at("unsupported") == "bad \uFFFD byte");
}

}  // namespace plumb::compare
