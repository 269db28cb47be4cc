// SPDX-License-Identifier: MIT
#include <compare/bench/bench_table.h>

#include <sstream>

#include "catch.h"
#include "compare/bench/measured.h"

namespace plumb::compare {

TEST_CASE("times read as 1.23 ms, 12.3 us and 123 ms", "[compare][bench]") {
    CHECK(timeText(1.234) == "1.23 ms");
    CHECK(timeText(0.01234) == "12.3 us");
    CHECK(timeText(123.4) == "123 ms");
}

TEST_CASE("a table has times, ratios with their spread, memory, what was seen, means, growth and phases",
          "[compare][bench]") {
    std::vector<SceneBench> results{
        memberOf("six",
                 measuredScene("s", {measuredEngine("plumb", {1, 2, 4}), measuredEngine("box2d-2.4", {8, 8, 8})})),
        measuredScene("t", {measuredEngine("plumb", {1, 1, 1}), unableEngine("box2d-2.4")}),
        measuredScene("p_10", {measuredEngine("plumb", {1}), unableEngine("box2d-2.4")}, "p", 10),
        measuredScene("p_20", {measuredEngine("plumb", {2}), unableEngine("box2d-2.4")}, "p", 20)};
    results[0].engines[0].runs[0].integrity =
        Integrity{.highest = -0.25, .overlap = 0.004, .jointGap = 0.03, .passedWalls = 7};
    results[0].engines[0].runs[1].busy = 0.5;
    std::ostringstream out;
    const BenchTable table(out, 8);
    table.head();
    for (const SceneBench& scene : results) table.rows(scene);
    table.summary(results);
    const std::string text = out.str();
    INFO(text);
    for (const char* part : {"over Plumb", "3 ms", "24 ms", "8 (2 to 8)", "2.0", "-0.25 m", "4 mm", "30 mm", " 7\n",
                             "unsupported by", "it has no such thing", "geometric mean of 1 of six: 8.00",
                             "grows as bodies^1.000 from 10 to 20", "solve 1", "for 50 % of a run only"})
        CHECK(text.find(part) != std::string::npos);
}

}  // namespace plumb::compare
