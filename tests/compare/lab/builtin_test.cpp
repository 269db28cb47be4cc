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

}  // namespace

TEST_CASE("every lab that comes with Plumb passes, with a value for each check", "[compare][lab][slow]") {
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
    }
}

TEST_CASE("every lab passes without a Box2D, and without any engine", "[compare][lab][slow]") {
    for (const Lab& lab : builtinLabs()) {
        INFO(lab.name);
        CHECK(runLab(lab, {"plumb"}, engines()).verdict != Verdict::Fails);
        CHECK(runLab(lab, {"closed-form"}, engines()).verdict != Verdict::Fails);
    }
}

TEST_CASE("every graph has a title, named axes, and curves of their own names by rising x", "[compare][lab][slow]") {
    std::vector<Engine> stepping = engines();  // a lab is never given the closed form
    std::erase_if(stepping, [](const Engine& engine) { return engine.role == Role::Truth; });
    for (const Lab& lab : builtinLabs()) {
        const LabRun run = lab.run(stepping);
        CHECK_FALSE(run.seen.empty());
        std::set<std::string> titles;
        for (const Graph& graph : run.graphs) {
            INFO(lab.name << ": " << graph.title);
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
