// SPDX-License-Identifier: MIT
#include <compare/command/bench_command.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>

#include <compare/command/command.h>

#include "catch.h"
#include "compare/command/called.h"

namespace plumb::compare {
namespace {

void checkBenchRefused(const std::vector<std::string>& args, const std::string& saying) {
    const Called called = call(args);
    INFO(called.err);
    CHECK(called.status == 2);
    CHECK(std::count(called.err.begin(), called.err.end(), '\n') == 1);
    CHECK(called.err.find(saying) != std::string::npos);
}

}  // namespace

TEST_CASE("bench of small_50 writes sane numbers for every engine, and ratios of the same runs", "[compare][command]") {
    const Folder folder("plumb_bench_command_test");
    const auto start = std::chrono::steady_clock::now();
    const Called called =
        call({"bench", "small_50", "--repeat", "3", "--steps", "20", "--threads", "1", "--json", folder / "b.json"});
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    INFO(called.out << called.err);
    CHECK(called.status == 0);
    CHECK(called.out.find("small_50") != std::string::npos);
    const nlohmann::json json = nlohmann::json::parse(textOf(folder / "b.json"));
    CHECK(json["schema"] == 1);
    CHECK(json["runs"].size() == engines().size() - 1);  // all but the closed form
    for (const nlohmann::json& run : json["runs"]) {
        INFO(run.dump());
        CHECK(run["bodies"] == 50);
        CHECK(run["steps"] == 20);
        CHECK(run["threads"] == 1);
        const nlohmann::json& ms = run["ms_per_step"];
        CHECK(ms["min"] > 0);
        CHECK(ms["min"] <= ms["median"]);
        CHECK(ms["median"] <= ms["max"]);
        CHECK(ms["max"] < 1000);
        CHECK(run["peak_kb"] > 1000);  // a program and its libraries
        double phases = 0;
        for (const auto& [name, value] : run["phases"].items()) phases += value.get<double>();
        if (run["engine"] != "chipmunk") CHECK(phases > 0);  // it tells of none
        // Engines measure their phases by the clock, which also counts what a busy machine does in between.
        CHECK(3 * 20 * phases < took.count());  // of 3 runs of 20 steps
    }
    REQUIRE(json["ratios"].size() == engines().size() - 2);
    for (const nlohmann::json& ratio : json["ratios"]) {
        CHECK(ratio["engine"] == "plumb");
        CHECK(ratio["ratio"]["min"] > 0);
        CHECK(ratio["ratio"]["min"] <= ratio["ratio"]["max"]);
    }
}

TEST_CASE("bench takes built-in scenes and files too, and a group stands for its scenes", "[compare][command]") {
    const Folder folder("plumb_bench_command_test");
    std::ofstream(folder / "mine.json") << call({"export", "stack_of_ten"}).out;
    const Called called =
        call({"bench", "free_fall", folder / "mine.json", "--repeat", "1", "--steps", "2", "--engines", "plumb"});
    INFO(called.out << called.err);
    CHECK(called.status == 0);
    CHECK(called.out.find("\nfree_fall ") != std::string::npos);
    CHECK(called.out.find("\nstack_of_ten ") != std::string::npos);
}

TEST_CASE("bench puts its tables into a page, and leaves the rest of it", "[compare][command]") {
    if (std::ranges::find(engines(), "box2d-3", &Engine::name) == engines().end()) return;
    const Folder folder("plumb_bench_command_test");
    std::ofstream(folder / "a.md") << "before\n<!-- bench: speed -->\n<!-- end -->\nafter\n";
    std::ofstream(folder / "b.md")
        << "<!-- bench: integrity -->\n<!-- end --><!-- bench: summary -->\nold\n<!-- end -->";
    const Called called = call({"bench", "small_50", "--repeat", "1", "--steps", "2", "--readme", folder / "a.md",
                                "--readme", folder / "b.md"});
    INFO(called.err);
    CHECK(called.status == 0);
    const std::string text = textOf(folder / "a.md");
    CHECK(text.starts_with("before\n<!-- bench: speed, checksum "));
    CHECK(text.find(" -->\n| scene | bodies | Plumb | Box2D 2.4") != std::string::npos);
    CHECK(text.find("\n| small_50 | 50 | ") != std::string::npos);
    CHECK(text.ends_with("<!-- end -->\nafter\n"));
    CHECK(textOf(folder / "b.md").find("| small_50 |") != std::string::npos);
    CHECK(textOf(folder / "b.md").find("<!-- bench: summary -->\nold\n") != std::string::npos);
    CHECK(called.out.find("the block summary stays as it is") != std::string::npos);
}

TEST_CASE("bench refuses bad usage with status 2 and one line", "[compare][command]") {
    const Folder folder("plumb_bench_command_test");
    checkBenchRefused({"bench", "large_pyramids"},
                      "there is no scene \"large_pyramids\": the nearest is large_pyramid; known are six, ");
    checkBenchRefused({"bench", "smash", "six"}, "both called \"smash\"");
    for (const std::string bad : {"0", "-1", "2.5", "many", ""}) {
        checkBenchRefused({"bench", "small_50", "--repeat=" + bad}, "--repeat");
        checkBenchRefused({"bench", "small_50", "--steps=" + bad}, "--steps");
        checkBenchRefused({"bench", "small_50", "--threads=" + bad}, "--threads");
    }
    checkBenchRefused({"bench", "small_50", "--threads", "2"},
                      "--threads: 2 is not 1: Plumb steps on one thread so far");
    checkBenchRefused({"bench", "small_50", "--engines", "closed-form"}, "--engines: \"closed-form\" is not an engine");
    checkBenchRefused({"bench", "small_50", "--csv", "x"}, "--csv");
    checkBenchRefused({"bench", "small_50", "--json", folder / "no/such/folder/b.json"}, "--json: cannot write");
    std::ofstream(folder / "empty.md") << "nothing\n";
    checkBenchRefused({"bench", "small_50", "--readme", folder / "empty.md"}, "empty.md: it has no block");
    checkBenchRefused({"bench", "small_50", "--readme", folder / "none.md"}, "none.md: cannot be read");
}

}  // namespace plumb::compare
