// SPDX-License-Identifier: MIT
#include <compare/lab/builtin.h>

#include <algorithm>
#include <set>

#include <compare/engine/engine.h>
#include <compare/scene/bench.h>
#include <compare/scene/builtin.h>

#include "catch.h"

namespace plumb::compare {
namespace {

bool isSorted(const Curve& curve) {
    return std::ranges::is_sorted(curve.points, {}, &Point::x);
}

/// Titles, named axes, and curves of names of their own by rising x.
void checkGraphs(const LabRun& run) {
    CHECK_FALSE(run.seen.empty());
    std::set<std::string> titles;
    for (const Graph& graph : run.graphs) {
        INFO(graph.title);
        CHECK(titles.insert(graph.title).second);
        CHECK_FALSE(graph.x.label.empty());
        CHECK_FALSE(graph.y.label.empty());
        std::set<std::string> names;
        for (const Curve& curve : graph.curves) {
            INFO(curve.name);
            CHECK(names.insert(curve.name).second);
            CHECK(curve.points.size() > 1);
            CHECK(isSorted(curve));
        }
    }
}

}  // namespace

TEST_CASE("every lab that comes with Plumb passes, with a value for each check and graphs that tell what they show",
          "[compare][lab][slow]") {
    for (const Lab& lab : builtinLabs()) {
        INFO(lab.name);
        const LabResult result = runLab(lab, {}, engines());
        CHECK(result.outcomes.size() == lab.checks.size());
        for (const LabOutcome& outcome : result.outcomes) {
            CAPTURE(outcome.check.name, outcome.value.value_or(-1), outcome.check.limit);
            CHECK(outcome.value);
            CHECK(outcome.pass);
        }
        CHECK(result.verdict == Verdict::Holds);
        checkGraphs(result.run);
    }
}

TEST_CASE("every lab passes without a Box2D, and without any engine", "[compare][lab][slow]") {
    for (const Lab& lab : builtinLabs()) {
        INFO(lab.name);
        CHECK(runLab(lab, {"plumb"}, engines()).verdict != Verdict::Fails);
        CHECK(runLab(lab, {"closed-form"}, engines()).verdict != Verdict::Fails);
    }
}

TEST_CASE("a lab's name is no scene's, and its checks have names of their own and reasons", "[compare][lab]") {
    for (const Lab& lab : builtinLabs()) {
        INFO(lab.name);
        CHECK_FALSE(findScene(lab.name));
        CHECK(findBenchScenes(lab.name).empty());
        CHECK(findLab(lab.name)->question == lab.question);
        CHECK(lab.question.ends_with("?"));
        CHECK_FALSE(lab.varied.empty());
        std::set<std::string> names;
        for (const LabCheck& check : lab.checks) {
            CHECK(names.insert(check.name).second);
            CHECK_FALSE(check.reason.empty());
        }
    }
    CHECK_FALSE(findLab("free_fall"));
}

}  // namespace plumb::compare
