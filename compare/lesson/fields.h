// SPDX-License-Identifier: MIT
// Which fields does a lesson have in a file, and which values may they have? See scene/fields.h.
#pragma once
#include <array>
#include <span>

#include <compare/lesson/lesson.h>
#include <compare/scene/fields.h>

namespace plumb::compare {

inline constexpr std::array predictionTags{"number", "choice", "curve"};
inline constexpr std::array<const char*, 10> shownTags{"path",     "trails", "velocity", "components", "acceleration",
                                                       "momentum", "force",  "causes",   "bounds",     "tests"};
constexpr std::span<const char* const> tagsOf(Shown) {
    return shownTags;
}

void fields(auto& visit, OrConst<LessonValue> auto& x) {
    visit(needed({"label", "", Allowed::any, "what a reader calls it"}), x.label);
    visit(needed({"value", "", Allowed::any, "what is read of the run: a query"}), x.value);
}
void fields(auto& visit, OrConst<NumberPrediction> auto& x) {
    visit(needed({"label", "", Allowed::any, "what a reader calls it"}), x.label);
    visit(needed({"value", "", Allowed::any, "what is read of the run: a query"}), x.value);
    visit({"unit", "", Allowed::any, "as it is printed"}, x.unit);
    visit({"from", "the unit", Allowed::finite, "the least that may be said"}, x.from);
    visit({"to", "the unit", Allowed::finite, "the most that may be said"}, x.to);
    visit({"within", "-", Allowed::positive, "so near, as a share of the true value, is right"}, x.within);
    visit({"tries", "", Allowed::any, "label of the control that takes what is said, before the run"}, x.tries);
}
void fields(auto& visit, OrConst<ChoicePrediction> auto& x) {
    visit(needed({"options", "", Allowed::any, "sentences, of which one holds"}, 2), x.options);
    visit({"right", "", Allowed::any, "which one holds, from 1"}, x.right);
}
void fields(auto& visit, OrConst<CurvePrediction> auto& x) {
    visit(needed({"label", "", Allowed::any, "what a reader calls it"}), x.label);
    visit(needed({"value", "", Allowed::any, "the quantity over time: \"y of ball\""}), x.value);
    visit({"unit", "", Allowed::any, "as it is printed"}, x.unit);
    visit({"within", "-", Allowed::positive, "a mean distance up to this share of the curve's range is right"},
          x.within);
}
void fields(auto& visit, OrConst<Prediction> auto& x) {
    visit.oneOf(x, predictionTags);
}
void fields(auto& visit, OrConst<WorseCase> auto& x) {
    visit(needed({"title", "", Allowed::any, "what is worse"}), x.title);
    visit(needed({"engine", "", Allowed::any, "the name of the engine that shows it"}), x.engine);
    visit({"set", "", Allowed::any, "PATH=VALUE, as check --set has them"}, x.set);
    visit(needed({"says", "", Allowed::any, "what comes of it, with queries of its run between braces"}), x.says);
}
void fields(auto& visit, OrConst<LessonQuestion> auto& x) {
    visit(needed({"ask", "", Allowed::any, "the question"}), x.ask);
    visit(needed({"answer", "", Allowed::any, "its answer, with queries between braces"}), x.answer);
}
void fields(auto& visit, OrConst<Lesson> auto& x) {
    visit(needed({"name", "", Allowed::any, "of small letters, digits and underscores"}), x.name);
    visit({"slides", "", Allowed::any, "numbers of the lecture's slides"}, x.slides);
    visit(needed({"title", "", Allowed::any, "for a reader"}), x.title);
    visit(needed({"about", "", Allowed::any, "what it is about, in one to three sentences"}), x.about);
    visit({"set", "", Allowed::any, "PATH=VALUE in the scene, as check --set has them"}, x.set);
    visit(needed({"engines", "", Allowed::any, "the names of those that run from the start"}), x.engines);
    visit(needed({"question", "", Allowed::any, "what is asked before the run"}), x.question);
    visit(needed({"predict", "", Allowed::any, "what is predicted: a number, a choice or a curve"}), x.predict);
    visit(needed({"because", "", Allowed::any, "why it is so, with queries between braces"}), x.because);
    visit({"controls", "", Allowed::any, "what may be turned, as in a scene"}, x.controls);
    visit({"show", "", Allowed::any, "what is drawn besides the bodies"}, x.show);
    visit({"charts", "", Allowed::any,
           "over time; the value is a quantity, \"y of ball\", \"energy\", \"causes\", \"error\""},
          x.charts);
    visit({"numbers", "", Allowed::any, "for a table, beside what is predicted"}, x.numbers);
    visit({"formula", "", Allowed::any, "lines in LaTeX, with queries between < and >"}, x.formula);
    visit({"worse", "", Allowed::any, "engines and settings that are worse"}, x.worse);
    visit(needed({"questions", "", Allowed::any, "for the worksheet, with answers"}), x.questions);
    visit({"counts", "", Allowed::any, "numbers that the scene's name may end in: how many bodies there are"},
          x.counts);
    visit({"countsSteps", "", Allowed::any, "does a page count steps in place of seconds?"}, x.countsSteps);
}

}  // namespace plumb::compare
