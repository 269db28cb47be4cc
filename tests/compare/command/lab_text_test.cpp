// SPDX-License-Identifier: MIT
#include <compare/command/lab_text.h>

#include <sstream>

#include "catch.h"
#include "compare/lab/example_lab.h"

namespace plumb::compare {
namespace {

std::string shownLabs(const std::vector<LabResult>& results, bool colour) {
    std::ostringstream out;
    for (const LabResult& result : results) printLab(result, out, colour);
    printLabSummary(results, out, colour);
    return out.str();
}

}  // namespace

TEST_CASE("a lab is told with a line a check, and of what fails why it should hold", "[compare][command]") {
    CHECK(shownLabs({exampleResult(2), exampleResult(3)}, false) ==
          "PASS  example_lab\n"
          "      ok    slope  2 m/s, at most 2.5 m/s\n"
          "FAIL  example_lab\n"
          "      FAIL  slope  3 m/s, at most 2.5 m/s: it is 2\n"
          "1 lab holds, 1 fails.\n");
    CHECK(shownLabs({exampleResult(2), exampleResult(2)}, false).ends_with("2 labs hold, 0 fail.\n"));
}

TEST_CASE("a value that was not measured is said not to exist", "[compare][command]") {
    Lab lab = exampleLab(2);
    lab.checks = {{.name = "other", .bound = Bound::AtLeast, .limit = 1, .reason = "why not"}};
    CHECK(shownLabs({runLab(lab, {}, {})}, false).find("FAIL  other  does not exist, at least 1: why not\n") !=
          std::string::npos);
}

TEST_CASE("a lab of which nothing was judged is not called a pass", "[compare][command]") {
    Lab lab = exampleLab(2);
    lab.checks.front().engine = "box2d-3";
    const LabResult unbound = runLab(lab, {}, {});
    lab.checks.clear();
    CHECK(shownLabs({unbound, runLab(lab, {}, {})}, false) ==
          "----  example_lab\n"
          "      no check binds these engines\n"
          "----  example_lab\n"
          "      this lab has no checks\n"
          "0 labs hold, 0 fail, 2 not judged.\n");
    CHECK(shownLabs({unbound}, true).find("\x1b[90m----\x1b[0m") != std::string::npos);
}

TEST_CASE("only a terminal gets a lab in colours", "[compare][command]") {
    CHECK(shownLabs({exampleResult(2)}, false).find('\x1b') == std::string::npos);
    CHECK(shownLabs({exampleResult(2)}, true).find("\x1b[32mPASS\x1b[0m") != std::string::npos);
    CHECK(shownLabs({exampleResult(3)}, true).find("\x1b[31mFAIL\x1b[0m") != std::string::npos);
}

TEST_CASE("the list tells what a lab asks, varies and checks", "[compare][command]") {
    std::ostringstream out;
    listLabs(std::vector<Lab>{exampleLab(2)}, out);
    CHECK(out.str() ==
          "example_lab\n"
          "    Does </script> end the page?\n"
          "    a lab; varied: x, from 1 to 4\n"
          "    slope: at most 2.5 m/s\n");
}

}  // namespace plumb::compare
