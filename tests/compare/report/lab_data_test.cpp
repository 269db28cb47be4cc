// SPDX-License-Identifier: MIT
#include <compare/report/data.h>

#include <nlohmann/json.hpp>

#include "catch.h"
#include "compare/lab/example_lab.h"
#include "unpacked.h"

namespace plumb::compare {

using nlohmann::json;

TEST_CASE("the page knows a lab's graphs, its curves' points, what was seen and what failed", "[compare][report]") {
    const json data = reportData({}, {exampleResult(3)});
    CHECK(data.at("scenes").empty());
    const json& lab = data.at("labs").at(0);
    CHECK(lab.at("name") == "example_lab");
    CHECK(lab.at("varied") == "x, from 1 to 4");
    CHECK(lab.at("pass") == false);
    CHECK(lab.at("seen") == json({"The way grows by 2 m a second."}));
    CHECK(lab.at("outcomes").at(0) == json::parse(R"({"check": "slope", "value": 3.0, "limit": 2.5, "atMost": true,
        "unit": "m/s", "reason": "it is 2", "pass": false})"));
    REQUIRE(lab.at("graphs").size() == 2);
    const json& graph = lab.at("graphs").at(1);
    CHECK(graph.at("x") == json({{"label", "time"}, {"unit", "s"}, {"logarithmic", true}}));
    const json& curve = graph.at("curves").at(0);
    CHECK(curve.at("note") == "slope 1");
    CHECK(unpackedDoubles(curve.at("xs")) == std::vector<double>{1, 2, 4});
    CHECK(unpackedDoubles(curve.at("ys")) == std::vector<double>{2, 4, 8});
}

TEST_CASE("the page knows of a lab without checks that it was not judged", "[compare][report]") {
    Lab lab = exampleLab(2);
    lab.checks.clear();
    const json data = labsData({runLab(lab, {}, {})}).at(0);
    CHECK(data.at("pass").is_null());
    CHECK(data.at("checks") == 0);
}

TEST_CASE("a value that was not measured comes to the page as null", "[compare][report]") {
    Lab lab = exampleLab(2);
    lab.checks.front().name = "another";
    CHECK(labsData({runLab(lab, {}, {})}).at(0).at("outcomes").at(0).at("value").is_null());
}

}  // namespace plumb::compare
