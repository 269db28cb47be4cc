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
              .starts_with("f:1: predict.number.value: \"z\" is not the name of a value of a body"));
    CHECK(complaintWith("/predict", {{"choice", {{"options", {"a", "b"}}, {"right", 3}}}}) ==
          "f:1: predict.choice.right: 3 is not one of the options, from 1 to 2");
    CHECK(complaintWith("/predict", {{"curve", {{"label", "l"}, {"value", "first maximum of y of ball"}}}}) ==
          "f:1: predict.curve.value: \"first maximum of y of ball\" is no quantity over time, as y of ball is");
    CHECK(complaintWith("/because", "It is {y of ball") == "f:1: because: a { is not closed");
    CHECK(complaintWith("/formula/0", "<y of bal>")
              .starts_with("f:1: formula[0]: \"bal\" is not the name of a "
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

TEST_CASE("a unit, a share or a brace that does not fit is refused, and what is predicted must happen in its range",
          "[compare][lesson][errors]") {
    CHECK(complaintWith("/predict/number/unit", "cm") ==
          "f:1: predict.number.unit: \"cm\", but \"first maximum of y of ball\" is read in m");
    CHECK(complaintWith("/predict/number/within", 3) ==
          "f:1: predict.number.within: 3 is more than the whole: 0.03 is 3 per cent");
    CHECK(complaintWith("/predict/number/tries", "Angle")
              .starts_with("f:1: predict.number.tries: \"Angle\" is not the name of a control, there is none"));
    CHECK(complaintWith("/because", "{y of ball and {x of ball}") == "f:1: because: a { is not closed");
    CHECK(complaintWith("/because", "{y of ball at end}") ==
          "f:1: because: \"y of ball at end\" is read at the end without \"at end\"");
    Json nothing = stone();
    nothing.erase("predict");
    CHECK(complaintOf(nothing) == "f:1: predict: is not given, wanted a number, a choice or a curve");

    const auto faultWith = [](const Json& number) {
        Json lesson = stone();
        lesson["predict"]["number"].update(number);
        return runLesson(lessonFromJson(lesson.dump(), "f")).fault;
    };
    CHECK(faultWith({{"from", 0}, {"to", 6}}).empty());
    CHECK(faultWith({{"from", 0}, {"to", 4}}) ==
          "predict.number.to: the true value is 5 m, wanted one between from and to");
    CHECK(faultWith({{"value", "fifth maximum of y of ball"}}) ==
          "predict.number.value: \"fifth maximum of y of ball\" does not happen in the run");
}

TEST_CASE("a control must fit what it sets, and a setting for one engine an engine that runs",
          "[compare][lesson][errors]") {
    const auto control = [](const Json& changes) {
        Json given{{"label", "Speed"}, {"set", {"bodies.ball.velocity"}}, {"as", "y"}, {"from", 0}, {"to", 20}};
        given.update(changes);
        return complaintWith("/controls", Json::array({given}));
    };
    CHECK(control(Json::object()).empty());
    CHECK(control({{"from", 30}}) == "f:1: controls[0].to: 20 is not above from, 30");
    CHECK(control({{"step", 50}}) == "f:1: controls[0].step: 50 is more than from 0 to 20");
    CHECK(control({{"to", 8}}) == "f:1: controls[0].to: 8 is below what the lesson begins with, 10");
    CHECK(control({{"from", 11}}) == "f:1: controls[0].from: 11 is above what the lesson begins with, 10");
    CHECK(control({{"as", "number"}})
              .starts_with("f:1: controls[0].as: bodies.ball.velocity: holds [0.0,10.0], wanted x, y, size"));
    CHECK(control({{"set", {"duration"}}})
              .starts_with("f:1: controls[0].as: duration: holds 2.0, wanted a field that is a vector"));
    CHECK(control({{"as", "direction"}, {"to", 180}}).empty());

    CHECK(complaintWith("/worse/0/set/0", "plumb:gravity=0,-9") ==
          "f:1: worse[0].set: \"plumb\" before the colon is no engine of it, which are explicit-euler");
    CHECK(complaintWith("/worse/0/set/0", "explicit-euler:dt=1/5")
              .starts_with("f:1: worse[0].set: engines.explicit-euler.dt: is the same for all engines"));
    CHECK(complaintWith("/set/0", "box2d-2:gravity=0,-9")
              .starts_with("f:1: set: \"box2d-2\" before the colon is no engine of it"));
    CHECK(complaintWith("/scene", {{"name", "s"}, {"bodies", {{{"name", "a"}, {"positon", {0, 1}}}}}})
              .starts_with("f:1: scene.bodies[0].positon: unknown field"));
}

TEST_CASE("a lesson that names the closed form says why that does not run", "[compare][lesson]") {
    Json lesson = stone();
    CHECK(runLesson(lessonFromJson(lesson.dump(), "f")).withoutClosedForm.empty());
    lesson["scene"] = "stack_of_ten";
    lesson["set"] = Json::array();
    for (const char* field : {"formula", "worse"}) lesson[field] = Json::array();
    lesson["because"] = lesson["questions"][0]["answer"] = "It stands.";
    lesson["predict"] = {{"choice", {{"options", {"It stands.", "It falls."}}}}};
    CHECK_FALSE(runLesson(lessonFromJson(lesson.dump(), "f")).withoutClosedForm.empty());
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
        CHECK(result.fault.empty());
        CHECK(result.withoutClosedForm.empty());
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

TEST_CASE(
    "the scene of one's own on the page can be read, and its ball rebounds to e^2 of its height in the closed form",
    "[compare][lesson][house]") {
    const std::string page = test::textOf(test::repository / "compare/lesson/README.md");
    const std::size_t start = page.find("```json\n{\n  \"name\": \"drop\"") + 8;
    Json lesson = stone();
    lesson["scene"] = Json::parse(page.substr(start, page.find("```", start) - start));
    for (const char* field : {"formula", "worse", "set"}) lesson[field] = Json::array();
    lesson["because"] = "{first maximum of y of ball}";
    const LessonResult result = runLesson(lessonFromJson(lesson.dump(), "f"));
    CHECK(result.withoutClosedForm.empty());
    CHECK(numberOf(result, "first maximum of y of ball") == Approx(0.2 + 0.8 * 0.8 * 1.8).epsilon(1e-9));
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
