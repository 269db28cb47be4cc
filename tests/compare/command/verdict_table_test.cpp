// SPDX-License-Identifier: MIT
#include <compare/command/verdict_table.h>

#include <sstream>

#include "catch.h"
#include "compare/scripted.h"

namespace plumb::compare {
namespace {

SceneResult judged(const std::string& name, double plumb, double limit) {
    Scene scene = oneDisc();
    scene.name = name;
    scene.gravity = {0, 0};
    scene.checks = {ExactCheck{limit, "it was derived"}};
    return runScene(scene, {}, {standing("plumb", plumb), unsupporting("box2d-3"), standing("closed-form", 0)});
}

std::string shownVerdicts(const std::vector<SceneResult>& results, bool colour) {
    std::ostringstream out;
    std::vector<Scene> scenes;
    for (const SceneResult& result : results) scenes.push_back(result.scene);
    const VerdictTable table(out, {"plumb", "box2d-3"}, scenes, colour);
    table.head();
    for (const SceneResult& result : results) table.row(result);
    table.summary(results);
    return out.str();
}

}  // namespace

TEST_CASE("the table says of each scene whether it holds, by how much, and spells out what fails",
          "[compare][command]") {
    const std::string text = shownVerdicts({judged("good", 0.0125, 0.1), judged("not_so_good", 2, 0.1)}, false);
    CHECK(text ==
          "                   largest distance to the closed form; in brackets, where there is none: to plumb\n"
          "      scene              plumb      box2d-3  checks that hold\n"
          "PASS  good             12.5 mm  unsupported  1 of 1\n"
          "FAIL  not_so_good          2 m  unsupported  0 of 1\n"
          "      exact: plumb error_max is 2 m, over 0.1 m (the limit: it was derived)\n"
          "\n"
          "1 scene holds, 1 fails.\n"
          "2 checks: 2 of plumb.\n");
}

TEST_CASE("a scene of which nothing was judged is not called a pass", "[compare][command]") {
    SceneResult result = judged("idle", 0, 1);
    result.scene.checks.clear();
    result.outcomes.clear();
    result.verdict = Verdict::NotJudged;
    CHECK(shownVerdicts({result, judged("good", 0, 1)}, false) ==
          "             largest distance to the closed form; in brackets, where there is none: to plumb\n"
          "      scene        plumb      box2d-3  checks that hold\n"
          "----  idle           0 m  unsupported  this scene has no checks\n"
          "PASS  good           0 m  unsupported  1 of 1\n"
          "\n"
          "1 scene holds, 0 fail, 1 not judged.\n"
          "1 check: 1 of plumb.\n");
}

TEST_CASE("what a scene sets for one engine alone stands beside the partings", "[compare][command]") {
    SceneResult result = judged("good", 0, 1);
    result.scene.engines["plumb"]["bodies.disc.material.friction"] = "0.3";
    result.scene.engines["another"]["gravity"] = "[0, 0]";
    std::ostringstream out;
    VerdictTable(out, {"plumb"}, std::vector<Scene>{result.scene}, false).partings(result);
    CHECK(out.str().find("      plumb: bodies.disc.material.friction = 0.3, for this engine alone\n") !=
          std::string::npos);
    CHECK(out.str().find("another") == std::string::npos);
}

TEST_CASE("only a terminal gets colours", "[compare][command]") {
    const std::vector<SceneResult> results{judged("good", 0, 1)};
    CHECK(shownVerdicts(results, false).find('\x1b') == std::string::npos);
    CHECK(shownVerdicts(results, true).find("\x1b[32mPASS\x1b[0m") != std::string::npos);
    CHECK(shownVerdicts(results, true).find("\x1b[32m1 scene holds\x1b[0m, \x1b[32m0 fail\x1b[0m.") !=
          std::string::npos);
}

TEST_CASE("a failed check is told with its value, its bound and its reason", "[compare][command]") {
    const Scene scene = oneDisc();
    CHECK(failureText(scene, {"order", "plumb", "order", 1.25, 1.8, false, "second order"}) ==
          "order: plumb order is 1.25, under 1.8 (the limit: second order)");
    CHECK(failureText(scene, {"invariant", "box2d-3", "settle_time", {}, 3, false, ""}) ==
          "invariant: box2d-3 settle_time does not exist, wanted at most 3 s");
    CHECK(failureText(scene, {"invariant", "plumb", "energy_drift", 0.5, 0.01, false, ""}) ==
          "invariant: plumb energy_drift is 0.5, over 0.01");
    CHECK(failureText(scene, {"exact", "plumb", "error_max", {}, 0.01, false, "", "closedForm.bodies.a: it tips"}) ==
          "exact: plumb error_max is not known: closedForm.bodies.a: it tips");
}

}  // namespace plumb::compare
