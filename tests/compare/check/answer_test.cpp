// SPDX-License-Identifier: MIT
#include <compare/check/answer.h>

#include <compare/scene/answer.h>
#include <compare/scene/builtin.h>

#include "catch.h"
#include "compare/scripted.h"

namespace plumb::compare {
namespace {

/// A disc that rises and falls along a parabola whose top is 2 m, at 0.4 s.
std::string answered(const std::string& answer) {
    Scene scene = oneDisc();
    scene.answer = answer;
    const Engine engine =
        scripted("plumb", {[](double t) { return std::vector<BodyState>{at(3 * t, 2 - 10 * (t - 0.4) * (t - 0.4))}; }});
    const Observation run = observe(scene, engine);
    return answerOf(scene, run, measure(scene, run, nullptr, nullptr));
}

std::string answerComplaint(const std::string& answer) {
    Scene scene = oneDisc();
    scene.answer = answer;
    try {
        validate(scene);
        return "";
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
}

}  // namespace

TEST_CASE("an answer reads the end, a time, extremes, their times and changes out of a run", "[compare][check]") {
    CHECK(answered("far {x of disc}") == "far 3 m");
    CHECK(answered("{x of disc at 0.5}") == "1.5 m");
    CHECK(answered("top {largest y of disc} at {time of largest y of disc}.") == "top 2 m at 0.4 s.");
    CHECK(answered("{smallest y of disc}, {time of smallest y of disc}") == "-1.6 m, 1 s");
    CHECK(answered("{change of y of disc}, {drop of y of disc}") == "-2 m, 2 m");
    CHECK(answered("{angle of disc}, {speed of disc}, {spin of disc}") == "0 deg, 0 m/s, 0 rad/s");
    CHECK(answered("").empty());
}

TEST_CASE("an answer that is not understood, or asks for what the scene has not, is refused",
          "[compare][check][errors]") {
    CHECK(answerComplaint("{y of disc").find("answer: a { is not closed") == 0);
    CHECK(answerComplaint("{height of disc}").find("answer: \"height\" is not the name of a value of a body") == 0);
    CHECK(answerComplaint("{y of disk}").find("answer: \"disk\" is not the name of a body, the nearest is disc") == 0);
    CHECK(answerComplaint("{y disc}").find("answer: \"y disc\" does not say of which body") == 0);
    CHECK(answerComplaint("{y of disc at noon}").find("answer: \"noon\" in \"y of disc at noon\" is not a time") == 0);
    CHECK(answerComplaint("{metric energy}").find("answer: \"energy\" is not the name of a metric of this scene") == 0);
    CHECK(answerComplaint("{y of disc} and {metric energy_drift}").empty());
}

TEST_CASE("every built-in scene has an answer with numbers", "[compare][check]") {
    for (const Scene& scene : builtinScenes()) {
        INFO(scene.name);
        CHECK(answerParts(scene).size() > 1);
    }
}

}  // namespace plumb::compare
