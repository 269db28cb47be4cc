// SPDX-License-Identifier: MIT
#include <compare/bench/result.h>

#include <cmath>
#include <limits>

#include "catch.h"
#include "compare/bench/measured.h"

namespace plumb::compare {

using Catch::Matchers::WithinAbs;

TEST_CASE("of 3, 1, 2 the median is 2, of 4, 1, 2, 3 it is 2.5", "[compare][bench]") {
    const Spread odd = spreadOf({3, 1, 2});
    CHECK(odd.min == 1);
    CHECK(odd.median == 2);
    CHECK(odd.max == 3);
    CHECK(spreadOf({4, 1, 2, 3}).median == 2.5);
    CHECK(spreadOf({7}).median == 7);
}

TEST_CASE("of 200 steps of 1 to 200 ms the middle one is 100, 99 % are up to 198, the worst is 200",
          "[compare][bench]") {
    std::vector<double> steps;
    for (int i = 200; i > 0; --i) steps.push_back(i);
    const StepTimes times = stepTimesOf(steps);
    CHECK(times.median == 100);
    CHECK(times.p99 == 198);
    CHECK(times.worst == 200);
}

TEST_CASE("a step's time is its least over the repeats", "[compare][bench]") {
    EngineBench bench;
    bench.runs = {{.stepMs = {1, 9, 3}}, {.stepMs = {5, 2, 4}}};
    CHECK(bench.stepMs().worst == 3);
    CHECK(bench.stepMs().median == 2);
    CHECK(bench.leastMs() == 2);  // of 1, 2 and 3
}

TEST_CASE("ratios go run by run, so a slow machine in one repeat does not show", "[compare][bench]") {
    // the second repeat took everybody ten times as long
    const std::vector<SceneBench> results{
        measuredScene("s", {measuredEngine("plumb", {1, 10, 2}), measuredEngine("box2d-2.4", {4, 40, 6})})};
    const std::vector<Ratio> ratios = ratiosOf(results);
    REQUIRE(ratios.size() == 1);
    CHECK(ratios[0].scene == "s");
    CHECK(ratios[0].against == "box2d-2.4");
    CHECK(ratios[0].ratio.min == 3);
    CHECK(ratios[0].ratio.median == 4);
    CHECK(ratios[0].ratio.max == 4);
}

TEST_CASE("a run that is not repeated has a ratio to the first run of the other", "[compare][bench]") {
    const std::vector<Ratio> ratios = ratiosOf(
        std::vector<SceneBench>{measuredScene("s", {measuredEngine("plumb", {1, 2}), measuredEngine("b", {6})})});
    REQUIRE(ratios.size() == 1);
    CHECK(ratios[0].ratio.min == 6);
    CHECK(ratios[0].ratio.max == 6);
    CHECK(ratios[0].least == 6);
}

TEST_CASE("what the first look found stands for the engine", "[compare][bench]") {
    EngineBench bench;
    bench.runs = {{.integrity = Integrity{.highest = 3}}, {}};
    CHECK(bench.integrity().highest == 3.0);
    CHECK_FALSE(EngineBench{}.integrity().highest);
}

TEST_CASE("an engine that cannot build a scene has no ratio, and without Plumb there is none", "[compare][bench]") {
    CHECK(
        ratiosOf(std::vector<SceneBench>{measuredScene("s", {measuredEngine("plumb", {1}), unableEngine("box2d-2.4")})})
            .empty());
    CHECK(ratiosOf(std::vector<SceneBench>{measuredScene("s", {measuredEngine("box2d-2.4", {1})})}).empty());
}

TEST_CASE("the geometric mean of ratios 2 and 8 is 4, of each group by itself", "[compare][bench]") {
    const auto pair = [](const std::string& name, double ratio) {
        return measuredScene(name, {measuredEngine("plumb", {1}), measuredEngine("box2d-3", {ratio})});
    };
    const std::vector<SceneBench> results{
        memberOf("six", pair("a", 2)),
        memberOf("six", pair("b", 8)),
        memberOf("six", measuredScene("c", {measuredEngine("plumb", {1}), unableEngine("box2d-3")})),
        memberOf("random", pair("d", 0.5)),
        memberOf("scaling", pair("e", 1000)),
        pair("f", 1000)};
    const std::vector<MeanRatio> means = meanRatiosOf(results);
    REQUIRE(means.size() == 2);
    CHECK(means[0].group == "six");
    CHECK(means[1].group == "random");
    CHECK_THAT(means[1].ratio, WithinAbs(0.5, 1e-12));
    CHECK(means[0].against == "box2d-3");
    CHECK(means[0].scenes == 2);
    CHECK_THAT(means[0].ratio, WithinAbs(4, 1e-12));
}

TEST_CASE("a scene whose joints open by metres, or that loses a body, is marked and left out of the mean",
          "[compare][bench]") {
    const auto pair = [](const std::string& name, double ratio, const Integrity& plumb, const Integrity& other) {
        SceneBench scene = measuredScene(name, {measuredEngine("plumb", {1}), measuredEngine("box2d-3", {ratio})});
        scene.engines[0].runs[0].integrity = plumb;
        scene.engines[1].runs[0].integrity = other;
        return memberOf("six", scene);
    };
    const Integrity sound{.highest = 1, .jointGap = 0.2}, torn{.highest = 1, .jointGap = 3};
    const Integrity lost{.highest = std::numeric_limits<double>::infinity()};
    const std::vector<SceneBench> results{pair("sound", 2, sound, sound), pair("torn_here", 100, torn, sound),
                                          pair("torn_there", 100, sound, torn), pair("lost", 100, sound, lost)};
    const std::vector<Ratio> ratios = ratiosOf(results);
    CHECK_FALSE(ratios.at(0).broken);
    for (std::size_t i = 1; i < 4; ++i) CHECK(ratios.at(i).broken);
    const MeanRatio mean = meanRatiosOf(results).at(0);
    CHECK(mean.scenes == 1);
    CHECK_THAT(mean.ratio, WithinAbs(2, 1e-12));
    CHECK(mean.leftOut == std::vector<std::string>{"torn_here", "torn_there", "lost"});
}

TEST_CASE("time as n^1.25 over three sizes shows as growth of 1.25", "[compare][bench]") {
    std::vector<SceneBench> results;
    constexpr std::size_t sizes[] = {1000, 4000, 64000};
    for (const std::size_t n : sizes)
        results.push_back(measuredScene("p_" + std::to_string(n),
                                        {measuredEngine("plumb", {3e-4 * std::pow(static_cast<double>(n), 1.25)})}, "p",
                                        n));
    results.push_back(measuredScene("q_10", {measuredEngine("plumb", {1})}, "q", 10));  // one size: no growth
    const std::vector<Growth> growths = growthsOf(results);
    REQUIRE(growths.size() == 1);
    CHECK(growths[0].family == "p");
    CHECK(growths[0].engine == "plumb");
    CHECK_THAT(growths[0].exponent, WithinAbs(1.25, 1e-12));
    CHECK(growths[0].from == 1000);
    CHECK(growths[0].to == 64000);
}

}  // namespace plumb::compare
