// SPDX-License-Identifier: MIT
#include <compare/lesson/lesson.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>

#include <compare/engine/engine.h>
#include <compare/lesson/fields.h>
#include <compare/lesson/lesson_run.h>
#include <compare/scene/json_text.h>

#include "catch.h"
#include "house/repository.h"

namespace plumb::compare {
namespace {

/// A stone thrown up at 10 m/s under 10 m/s^2, as a lesson.
Json stone() {
    return {{"name", "thrown"},
            {"slides", {7}},
            {"title", "A stone"},
            {"about", "It flies."},
            {"scene", "free_fall"},
            {"set", {"gravity=0,-10", "bodies.ball.position=0,0", "bodies.ball.velocity=0,10"}},
            {"engines", {"plumb", "closed-form"}},
            {"question", "How high in {duration}?"},
            {"predict", {{"number", {{"label", "height"}, {"value", "first maximum of y of ball"}, {"unit", "m"}}}}},
            {"because", "{time when first maximum of y of ball}"},
            {"formula", {"h = <first maximum of y of ball>"}},
            {"worse",
             {{{"title", "Euler"},
               {"engine", "explicit-euler"},
               {"set", {"dt=1/10"}},
               {"says", "It comes to {first maximum of y of ball}."}}}},
            {"questions", {{{"ask", "How fast?"}, {"answer", "{speed of ball at start}"}}}}};
}

std::string complaintOf(const Json& lesson) {
    try {
        (void)lessonFromJson(lesson.dump(), "f");
        return "";
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
}

/// With another value at the path: "/predict/number/value".
std::string complaintWith(const std::string& path, const Json& value) {
    Json lesson = stone();
    lesson[Json::json_pointer(path)] = value;
    return complaintOf(lesson);
}

Lesson builtLesson(const std::string& file) {
    return lessonFromJson(test::textOf(test::repository / file), file);
}

std::vector<std::string> lessonFiles() {
    std::vector<std::string> files;
    for (const std::filesystem::path& path : test::repositoryFiles()) {
        const std::string name = path.generic_string();
        if (name.starts_with("compare/lesson/data/")) files.push_back(name);
    }
    return files;
}

double numberOf(const LessonResult& result, const std::string& query) {
    for (const LessonNumber& number : result.numbers)
        if (number.query == query) return number.value.value_or(-1);
    FAIL("there is no " << query);
    return 0;
}

}  // namespace

TEST_CASE("a stone thrown up at 10 m/s under 10 m/s^2 comes to 5 m, by explicit Euler at ten steps a second to 5.5 m",
          "[compare][lesson][slides]") {
    const LessonResult result = runLesson(lessonFromJson(stone().dump(), "f"));
    CHECK(numberOf(result, "first maximum of y of ball") == Approx(5).epsilon(0).margin(1e-12));
    CHECK(result.question == "How high in 2 s?");
    CHECK(result.because == "1 s");
    REQUIRE(result.worse.size() == 1);
    CHECK(result.worse[0].says == "It comes to 5.5 m.");
    CHECK(result.worse[0].value.value() == Approx(5.5).epsilon(0).margin(1e-9));
    CHECK(result.answers == std::vector<std::string>{"10 m/s"});
}

TEST_CASE("a lesson that is wrong is refused with its line, the field, the value and what was wanted",
          "[compare][lesson][errors]") {
    CHECK(complaintOf(stone()).empty());
    CHECK(complaintWith("/name", "A stone") ==
          "f:1: name: \"A stone\" is not made of small letters, digits and underscores");
    CHECK(complaintWith("/scene", "free_fal")
              .starts_with("f:1: scene: \"free_fal\" is not the name of a scene, the "
                           "nearest is free_fall"));
    CHECK(complaintWith("/set/0", "gravty=0,-10")
              .starts_with("f:1: set: gravty=0,-10: gravty: \"gravty\" is not a "
                           "field, the nearest is gravity"));
    CHECK(complaintWith("/engines/1", "closed_form")
              .starts_with("f:1: engines[1]: \"closed_form\" is not the name of "
                           "an engine, the nearest is closed-form"));
    CHECK(complaintWith("/predict/number/value", "first maximum of z of ball")
              .starts_with("f:1: predict.number.value: answer: \"z\" is not the name of a value of a body"));
    CHECK(complaintWith("/predict", {{"choice", {{"options", {"a", "b"}}, {"right", 3}}}}) ==
          "f:1: predict.choice.right: 3 is not one of the options, from 1 to 2");
    CHECK(complaintWith("/predict", {{"curve", {{"label", "l"}, {"value", "first maximum of y of ball"}}}}) ==
          "f:1: predict.curve.value: \"first maximum of y of ball\" is no quantity over time, as y of ball is");
    CHECK(complaintWith("/because", "It is {y of ball") == "f:1: because: a { is not closed");
    CHECK(complaintWith("/formula/0", "<y of bal>")
              .starts_with("f:1: formula[0]: answer: \"bal\" is not the name of a "
                           "body, the nearest is ball"));
    CHECK(complaintWith("/worse/0/engine", "euler")
              .starts_with("f:1: worse[0].engine: \"euler\" is not the name of an "
                           "engine"));
    CHECK(complaintWith("/worse/0/set/0", "dt=0").find("worse[0].set: dt=0: dt: 0 is not positive") !=
          std::string::npos);
    CHECK(complaintWith("/questions", Json::array()) == "f:1: questions: there is none, wanted at least one");
    CHECK(complaintWith("/controls", {{{"label", "x"}, {"set", {"bodies.bal.mass"}}}})
              .starts_with("f:1: controls[0].set: bodies.bal: \"bal\" is not the name of one of them, the nearest is "
                           "ball"));
    CHECK(complaintWith("/colour", "red").starts_with("f:1: colour: unknown field"));
    Json nothing = stone();
    nothing.erase("scene");
    CHECK(complaintOf(nothing) == "f:1: scene: is not given, wanted the name of a scene, or a scene");
}

TEST_CASE("each lesson can be read, has three questions, under 80 lines, and a number for each query",
          "[compare][lesson]") {
    std::set<std::string> titles;
    for (const std::string& file : lessonFiles()) {
        INFO(file);
        const std::string text = test::textOf(test::repository / file);
        CHECK(std::ranges::count(text, '\n') < 80);
        const Lesson lesson = builtLesson(file);
        CHECK(file == "compare/lesson/data/" + lesson.name + ".json");
        CHECK(titles.insert(lesson.title).second);
        CHECK(lesson.questions.size() == 3);
        CHECK_FALSE(lesson.slides.empty());
        const LessonResult result = runLesson(lesson);
        for (const LessonNumber& number : result.numbers) {
            INFO(number.query);
            CHECK(number.value);
        }
        for (const WorseResult& worse : result.worse) {
            INFO(worse.title);
            if (findKnown(worse.engine)->build) CHECK(worse.unsupported.empty());
        }
    }
}

TEST_CASE("the shortest lesson of the page is its example, and falls by 19.62 m", "[compare][lesson][house]") {
    const std::string example = test::textOf(test::repository / "compare/lesson/example.json");
    const std::string page = test::textOf(test::repository / "compare/lesson/README.md");
    CHECK(page.find("```json\n" + example + "```") != std::string::npos);
    CHECK(numberOf(runLesson(lessonFromJson(example, "f")), "drop of y of ball") == Approx(19.62).epsilon(1e-12));
}

TEST_CASE("the page on lessons names each field, each number of an engine for lessons, and each kind of prediction",
          "[compare][lesson][house]") {
    const std::string page = test::textOf(test::repository / "compare/lesson/README.md");
    const Json lesson = Json::parse(toJson(lessonFromJson(stone().dump(), "f")));
    for (const auto& [field, value] : lesson.items()) {
        INFO(field);
        CHECK(page.find("`" + field + "`") != std::string::npos);
    }
    for (const char* kind : predictionTags) CHECK(page.find("`" + std::string(kind) + "`") != std::string::npos);
    for (const char* shown : shownTags) CHECK(page.find("`" + std::string(shown) + "`") != std::string::npos);
    for (const Engine& engine : knownEngines()) {
        if (!engine.onDemand) continue;
        INFO(engine.name);
        CHECK(page.find("`" + engine.name + "`") != std::string::npos);
        for (const EngineNumber& number : engine.numbers)
            CHECK(page.find("`" + number.name + "`") != std::string::npos);
    }
}

}  // namespace plumb::compare
