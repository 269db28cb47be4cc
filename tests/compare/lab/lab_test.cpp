// SPDX-License-Identifier: MIT
#include <compare/lab/lab.h>

#include "catch.h"
#include "compare/scripted.h"
#include "example_lab.h"

namespace plumb::compare {
namespace {

/// A lab that measures the number of engines it is given, and nothing else.
Lab counting(const LabCheck& check) {
    return {.name = "counting", .checks = {check}, .run = [](const std::vector<Engine>& engines) {
                return LabRun{.values = {{"engines", static_cast<double>(engines.size())}}};
            }};
}

const std::vector<Engine> three{standing("plumb", 0), standing("box2d-3", 0), standing("closed-form", 0)};

}  // namespace

TEST_CASE("a value at its limit holds, and one beyond it fails the lab, from above and from below", "[compare][lab]") {
    CHECK(exampleResult(2.5).verdict == Verdict::Holds);
    CHECK(exampleResult(2.6).verdict == Verdict::Fails);
    const LabCheck atLeast{.name = "engines", .bound = Bound::AtLeast, .limit = 2};
    CHECK(runLab(counting(atLeast), {}, three).verdict == Verdict::Holds);
    CHECK(runLab(counting(atLeast), {"plumb"}, three).verdict == Verdict::Fails);
}

TEST_CASE("what was not measured, or is no number, does not hold", "[compare][lab]") {
    const LabResult missing = runLab(counting({.name = "another", .limit = 10}), {}, three);
    CHECK(missing.verdict == Verdict::Fails);
    CHECK_FALSE(missing.outcomes.at(0).value);
    for (const Bound bound : {Bound::AtMost, Bound::AtLeast}) {
        Lab lab = exampleLab(nan);
        lab.checks.front().bound = bound;
        CHECK(runLab(lab, {}, {}).verdict == Verdict::Fails);
    }
}

TEST_CASE("a lab is given the engines that were asked for, without the closed form", "[compare][lab]") {
    const LabCheck check{.name = "engines", .limit = 9};
    CHECK(runLab(counting(check), {}, three).run.values.at("engines") == 2);
    CHECK(runLab(counting(check), {"box2d-3", "closed-form"}, three).run.values.at("engines") == 1);
}

TEST_CASE("a check on an engine that is not run is not judged", "[compare][lab]") {
    const LabCheck check{.name = "another", .engine = "box2d-3"};
    const LabResult without = runLab(counting(check), {"plumb"}, three);
    CHECK(without.outcomes.empty());
    CHECK(without.verdict == Verdict::NotJudged);
    CHECK(runLab(counting(check), {}, three).outcomes.size() == 1);
}

}  // namespace plumb::compare
