// SPDX-License-Identifier: MIT
#include <compare/page/speed_tables.h>

#include <algorithm>

#include <compare/page/cells.h>

#include "catch.h"
#include "compare/bench/measured.h"

namespace plumb::compare {
namespace {

SceneBench pairOf(const std::string& name, double plumb, double box2d) {
    SceneBench scene = measuredScene(name, {measuredEngine("plumb", {plumb}), measuredEngine("box2d-3", {box2d})});
    scene.engines[1].version = "3.2.0";
    for (EngineBench& engine : scene.engines)
        engine.runs[0].integrity = Integrity{.highest = 2, .overlap = 1e-3, .passedWalls = 1};
    return scene;
}

std::string bodyOf(const std::vector<Block>& blocks, const std::string& name) {
    const auto block = std::ranges::find(blocks, name, &Block::name);
    return block == blocks.end() ? "" : block->body;
}

}  // namespace

TEST_CASE("the page has a row a scene: times, ratio, 99 % of the steps, the worst, memory, what was seen",
          "[compare][page]") {
    // steps of 1 to 5 ms times what is given: 3 in the mean
    const std::vector<Block> blocks = speedBlocks(
        std::vector<SceneBench>{memberOf("six", pairOf("s", 1, 4)), memberOf("six", pairOf("t", 0.01, 0.01)),
                                measuredScene("u", {measuredEngine("plumb", {1}), unableEngine("box2d-3")})});
    const std::string speed = bodyOf(blocks, "speed");
    INFO(speed);
    CHECK(speed.starts_with("| scene | bodies | Plumb | Box2D 3.2.0 | Box2D 3.2.0 over Plumb |"));
    CHECK(speed.find("| s | 10 | 3 ms | 12 ms | 4.0 (4.0–4.0) | 5 ms / 20 ms | 5 ms / 20 ms | 2 / 2 |\n") !=
          std::string::npos);
    CHECK(speed.find("| t | 10 | 30 µs | 30 µs | 1.0 (1.0–1.0) |") != std::string::npos);
    CHECK(speed.find("| u | 10 | 3 ms | – | – |") != std::string::npos);
    CHECK(speed.find("geometric mean of 2 of the six: 2.00.") != std::string::npos);
    CHECK(bodyOf(blocks, "integrity").find("| s | 2 m / 2 m | 1 mm / 1 mm | – / – | 1 / 1 |") != std::string::npos);
    CHECK(bodyOf(blocks, "phases").starts_with("- s: solve 100 %\n"));
    CHECK(bodyOf(blocks, "random").empty());
    CHECK(bodyOf(blocks, "summary").empty());  // its scenes were not run
}

TEST_CASE("on the page a scene whose joints open by metres is called broken, and left out of the mean",
          "[compare][page]") {
    std::vector<SceneBench> results{memberOf("six", pairOf("s", 1, 4)), memberOf("six", pairOf("net", 1, 100))};
    results[1].engines[0].runs[0].integrity->jointGap = 20;
    const std::string speed = bodyOf(speedBlocks(results), "speed");
    INFO(speed);
    CHECK(speed.find("| 100 (100–100), broken |") != std::string::npos);
    CHECK(speed.find("| 4.0 (4.0–4.0) |") != std::string::npos);
    CHECK(
        speed.find("geometric mean of 1 of the six: 4.00; left out, because a joint opened by more than 1 m or a body "
                   "was lost: net.") != std::string::npos);
}

TEST_CASE("the front page has a row for all random scenes", "[compare][page]") {
    std::vector<SceneBench> results;
    for (const char* name : {"small_50", "large_pyramid", "washer", "pit_2000", "spinner", "junkyard", "compounds",
                             "joint_grid", "dolls_100", "rain", "bridge_20", "rope_60"})
        results.push_back(pairOf(name, 1, 2));
    results.push_back(memberOf("random", pairOf("random_1", 1, 0.25)));
    results.push_back(memberOf("random", pairOf("random_2", 1, 0.5)));
    results.push_back(memberOf("random", pairOf("random_3", 1, 2)));
    const std::string summary = bodyOf(speedBlocks(results), "summary");
    INFO(summary);
    CHECK(summary.find("| 3 random scenes, geometric mean; Plumb is faster in 1 | – | – | 1.6 times as slow | – |") !=
          std::string::npos);
}

TEST_CASE("structures of joints have a table of their times and gaps", "[compare][page]") {
    std::vector<SceneBench> results;
    for (const char* name : {"bridge_20", "truss_32", "net_20", "net_40"}) results.push_back(pairOf(name, 1, 2));
    CHECK(bodyOf(speedBlocks(results), "jointed").empty());  // cloth_20 was not run
    results.push_back(pairOf("cloth_20", 1, 2));
    const std::string jointed = bodyOf(speedBlocks(results), "jointed");
    INFO(jointed);
    CHECK(jointed.find("| A cloth of 400 discs and 741 rods | 3 ms | 6 ms | 2.0 times as fast |") != std::string::npos);
}

TEST_CASE("random scenes stand in sums, with joints and without, and the slowest and the fastest by themselves",
          "[compare][page]") {
    std::vector<SceneBench> results;
    for (int i = 0; i < 12; ++i) {
        results.push_back(memberOf("random", pairOf("random_" + std::to_string(i), 1, i < 6 ? 0.25 : 4)));
        results.back().joints = i < 6 ? 3 : 0;
    }
    const std::vector<Block> blocks = speedBlocks(results);
    CHECK(bodyOf(blocks, "speed").empty());
    const std::string random = bodyOf(blocks, "random");
    INFO(random);
    CHECK(random.find("| all | 12 | 1.0 | 0.25 to 4.0 | 6 | 0 | 12 / 12 |") != std::string::npos);
    CHECK(random.find("| without joints | 6 | 4.0 | 4.0 to 4.0 | 6 |") != std::string::npos);
    CHECK(random.find("| with joints | 6 | 0.25 |") != std::string::npos);
    CHECK(random.find("| random_3 |") != std::string::npos);
    CHECK(random.find("| random_5 |") == std::string::npos);
    CHECK(random.find("| random_8 |") != std::string::npos);
}

TEST_CASE("times read as 1.23 ms and 12.3 µs, ratios as 140, 1.8 and 0.0021", "[compare][page]") {
    CHECK(milliseconds(1.234) == "1.23 ms");
    CHECK(milliseconds(0.01234) == "12.3 µs");
    CHECK(milliseconds(1312) == "1.31 s");
    CHECK(ratioText(140.4) == "140");
    CHECK(ratioText(1) == "1.0");
    CHECK(ratioText(1.84) == "1.8");
    CHECK(ratioText(0.00212) == "0.0021");
}

TEST_CASE("tables of speed without Plumb or without Box2D 3 are refused", "[compare][page]") {
    CHECK_THROWS_AS(speedBlocks(std::vector<SceneBench>{measuredScene("s", {measuredEngine("plumb", {1})})}),
                    std::invalid_argument);
    CHECK_THROWS_AS(speedBlocks(std::vector<SceneBench>{measuredScene("s", {measuredEngine("box2d-3", {1})})}),
                    std::invalid_argument);
}

}  // namespace plumb::compare
