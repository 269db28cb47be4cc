// SPDX-License-Identifier: MIT
// Which numbers does a lesson's run give?
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <compare/lesson/lesson.h>
#include <compare/metric/observation.h>

namespace plumb::compare {

/// A query, and what is true of it: in the closed form where that knows it, else in the engine under test.
struct LessonNumber {
    std::string query{};
    std::optional<double> value{};
    std::string unit{};  ///< "m", "deg"
};

/// What a worse case comes to.
struct WorseResult {
    std::string title{}, engine{};
    std::string unsupported{};      ///< why the engine does not run it; empty: it does
    std::optional<double> value{};  ///< of the query that is predicted; none if a lesson predicts no number
    std::string says{};             ///< its sentence with the numbers of its run
};

struct LessonResult {
    std::vector<LessonNumber> numbers{};  ///< of the prediction, of the formula and of all texts, each query once
    std::vector<WorseResult> worse{};
    std::string question{}, because{};
    std::vector<std::string> asked{}, answers{};  ///< its questions
    std::string withoutClosedForm{};  ///< why the closed form does not run, though the lesson names it; empty: it runs
    std::string fault{};  ///< "predict.number.to: ...": why what is predicted cannot be judged; empty: it can
};

/// Runs the lesson's engines and those of its worse cases.
LessonResult runLesson(const Lesson& lesson);

}  // namespace plumb::compare
