// SPDX-License-Identifier: MIT
// What is a lesson? A scene with a question, something to predict, and what a person may find out by it. As data.
#pragma once
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <compare/scene/answer.h>
#include <compare/scene/scene.h>
#include <compare/scene/set_field.h>

namespace plumb::compare {

/// What is read of a run, and what a reader calls it.
struct LessonValue {
    std::string label{};  ///< "height at the top"
    std::string value{};  ///< a query of the run: see scene/answer.h
};

/// A number, for example "how high?".
struct NumberPrediction {
    std::string label{};  ///< "height at the top"
    std::string value{};  ///< a query of the run: see scene/answer.h
    std::string unit{};   ///< as it is printed
    double from = 0, to = 10;
    double within = 0.02;  ///< so near, as a share of the true value, is right [-]
    std::string tries{};   ///< label of the control that takes what is said, before the run; "": none
};

/// One of several sentences.
struct ChoicePrediction {
    std::vector<std::string> options{};
    int right = 1;  ///< which one holds, from 1
};

/// A curve over the time of the run, drawn by hand.
struct CurvePrediction {
    std::string label{};   ///< "height"
    std::string value{};   ///< "y of ball": a quantity
    std::string unit{};    ///< as it is printed
    double within = 0.08;  ///< a mean distance up to this share of the range of the true curve is right [-]
};

using Prediction = std::variant<NumberPrediction, ChoicePrediction, CurvePrediction>;

/// What a page draws besides the bodies.
enum class Shown {
    Path,
    Trails,
    Velocity,
    Components,  ///< of velocity
    Acceleration,
    Momentum,
    Force,
    Causes,
    Bounds,  ///< of each body: a circle, an upright and an oriented box
    Tests,   ///< how many tests of pairs each broad phase makes
};

/// An engine, or a setting of one, that is worse than the lesson's own.
struct WorseCase {
    std::string title{};             ///< "Explicit Euler, ten steps a second"
    std::string engine{};            ///< its name
    std::vector<std::string> set{};  ///< PATH=VALUE
    std::string says{};              ///< what comes of it: with queries of its run between braces
};

struct LessonQuestion {
    std::string ask{}, answer{};
};

/// All texts are English. Between braces in a text, and between < and > in a formula, stands a query of the run.
struct Lesson {
    std::string name{};                  ///< snake_case
    std::vector<int> slides{};           ///< of the lecture
    std::string title{};                 ///< for people
    std::string about{};                 ///< what it is about: one to three sentences
    Scene scene{};                       ///< with all that the lesson sets, with its controls and its question
    std::vector<std::string> set{};      ///< PATH=VALUE, in the scene as it is built in
    std::vector<std::string> engines{};  ///< which run from the start
    std::string question{};
    Prediction predict{};
    std::string because{};  ///< why it is so: shown once there is a prediction
    std::vector<Shown> show{};
    std::vector<LessonValue> charts{};   ///< of quantities: "y of ball"; or "energy", "causes", "error"
    std::vector<LessonValue> numbers{};  ///< for a table, beside the predicted one
    std::vector<std::string> formula{};  ///< lines in LaTeX, worked with the numbers of the run
    std::vector<WorseCase> worse{};
    std::vector<LessonQuestion> questions{};
    std::vector<SceneControl> controls{};
    std::vector<int> counts{};  ///< numbers that the name of the scene may end in: how many bodies it has
    bool countsSteps = false;   ///< a page says which step it is, and not the time
};

/// Reads a lesson from JSON: "scene" is the name of a built-in scene, or a scene as `check` reads it. file: the name of
/// the text in messages. Throws std::invalid_argument, "FILE:LINE: predict.number.value: ...", as scene/json.h does.
Lesson lessonFromJson(std::string_view text, const std::string& file);

/// The lesson as JSON, with all fields but the scene.
std::string toJson(const Lesson& lesson);

/// Reads each "PATH=VALUE".
std::vector<FieldSetting> settingsOf(const std::vector<std::string>& texts);

/// Between which a query stands in a formula: braces are LaTeX's.
inline constexpr Marks formulaMarks{'<', '>'};

}  // namespace plumb::compare
