// SPDX-License-Identifier: MIT
#include <compare/bench/bench_json.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "compare/bench/measured.h"

namespace plumb::compare {

TEST_CASE("JSON of schema 1 has runs and ratios, and null where an engine could not", "[compare][bench]") {
    std::vector<SceneBench> results{measuredScene(
        "s",
        {measuredEngine("plumb", {1, 2, 4}, 4096), measuredEngine("box2d-2.4", {8, 8, 8}), unableEngine("box2d-3")})};
    results[0].engines[0].runs[0].integrity =
        Integrity{.highest = 2.5, .overlap = std::numeric_limits<double>::infinity(), .passedWalls = 4};
    const nlohmann::json json = nlohmann::json::parse(benchJson(results));
    CHECK(json["schema"] == 1);
    REQUIRE(json["runs"].size() == 3);
    const nlohmann::json& plumb = json["runs"][0];
    CHECK(plumb["scene"] == "s");
    CHECK(plumb["engine"] == "plumb");
    CHECK(plumb["threads"] == 1);
    CHECK(plumb["bodies"] == 10);
    CHECK(plumb["ms_per_step"] == nlohmann::json::parse(R"({"min": 1.0, "median": 2.0, "max": 4.0})"));
    CHECK(plumb["step_ms"] == nlohmann::json::parse(R"({"median": 3.0, "p99": 5.0, "worst": 5.0})"));
    CHECK(plumb["least_ms"] == 3.0);  // of 1 to 5 ms, when a step took 1 ms
    CHECK(plumb["integrity"] == nlohmann::json::parse(R"({"highest": 2.5, "overlap": "infinite", "joint_gap": null,
                                                           "passed_walls": 4})"));
    CHECK(plumb["peak_kb"] == 4096);
    CHECK(plumb["repeats"] == 3);
    CHECK(plumb["phases"].contains("solve"));
    CHECK(json["runs"][2]["unsupported"] == "it has no such thing");
    CHECK(json["runs"][2]["ms_per_step"].is_null());
    CHECK(json["runs"][2]["step_ms"].is_null());
    CHECK(json["runs"][2]["peak_kb"].is_null());
    REQUIRE(json["ratios"].size() == 1);
    CHECK(json["ratios"][0] == nlohmann::json::parse(R"({"scene": "s", "engine": "plumb", "against": "box2d-2.4",
                                                          "ratio": {"min": 2.0, "median": 4.0, "max": 8.0}, "least": 8.0, "broken": true})"));
    CHECK(json["mean_ratios"].empty());  // it belongs to no group
    CHECK(json["growth"].empty());
}

}  // namespace plumb::compare
