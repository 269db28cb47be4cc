// SPDX-License-Identifier: MIT
#include <compare/bench/readme.h>

#include "catch.h"
#include "compare/bench/measured.h"

namespace plumb::compare {

TEST_CASE("the table of the README has a row a scene, and each row as many cells as the head", "[compare][bench]") {
    const std::string text = benchMarkdown(std::vector<SceneBench>{
        measuredScene("s", {measuredEngine("plumb", {1, 2, 4}), measuredEngine("box2d-2.4", {8, 8, 8})}),
        measuredScene("t", {measuredEngine("plumb", {0.05, 0.05, 0.05}), unableEngine("box2d-2.4")})});
    CHECK(
        text.starts_with("| scene | bodies | Plumb | Box2D 2.4.1 | Box2D 2.4.1 over Plumb | peak MB: Plumb / Box2D "
                         "2.4.1 |\n|---|---|---|---|---|---|\n"));
    CHECK(text.find("| s | 10 | 2 ms | 8 ms | 4.00 (2.00–8.00) | 2 / 2 |\n") != std::string::npos);
    CHECK(text.find("| t | 10 | 50 µs | unsupported | – | 2 / – |\n") != std::string::npos);
    CHECK(text.find("median of 3 runs") != std::string::npos);
    CHECK(text.find("geometric mean of 1 scene: 4.00") != std::string::npos);
}

TEST_CASE("scenes of one kind and many sizes stand in the README by their growth", "[compare][bench]") {
    const std::string text =
        benchMarkdown(std::vector<SceneBench>{measuredScene("s", {measuredEngine("plumb", {2})}),
                                              measuredScene("heap_10", {measuredEngine("plumb", {1})}, "heap", 10),
                                              measuredScene("heap_40", {measuredEngine("plumb", {8})}, "heap", 40)});
    CHECK(text.find("| s |") != std::string::npos);
    CHECK(text.find("heap_") == std::string::npos);
    CHECK(text.find("From 10 to 40 bodies (heap) the time of a step grows as n^1.50 in Plumb.\n") != std::string::npos);
}

TEST_CASE("the README says what share of a step each of Plumb's phases has", "[compare][bench]") {
    EngineBench plumb = measuredEngine("plumb", {4});
    plumb.runs[0].phases = {{"pairs", 1e-3}, {"solve", 3e-3}};
    const std::string text = benchMarkdown(std::vector<SceneBench>{measuredScene("s", {plumb})});
    CHECK(text.find("- s: pairs 25 %, solve 75 %\n") != std::string::npos);
}

TEST_CASE("only what stands between the two lines is replaced, and again the same way", "[compare][bench]") {
    const std::string text = "a\n<!-- bench begin -->\nold\n<!-- bench end -->\nb\n";
    const std::string once = withBench(text, "new\n");
    CHECK(once == "a\n<!-- bench begin -->\nnew\n<!-- bench end -->\nb\n");
    CHECK(withBench(once, "new\n") == once);
}

TEST_CASE("a text without the two lines, or with one twice or in the wrong order, is refused", "[compare][bench]") {
    for (const char* text : {"", "<!-- bench begin -->\n", "<!-- bench end -->\n<!-- bench begin -->\n",
                             "<!-- bench begin -->\n<!-- bench begin -->\n<!-- bench end -->",
                             "<!-- bench begin -->\n<!-- bench end --><!-- bench end -->"})
        CHECK_THROWS_AS(withBench(text, "new"), std::invalid_argument);
    CHECK_THROWS_WITH(readReadme("/no/such/file.md"), "/no/such/file.md: cannot be read");
}

}  // namespace plumb::compare
