// SPDX-License-Identifier: MIT
#include <compare/lesson/lesson_run.h>

#include <algorithm>
#include <cmath>

#include <compare/check/answer.h>
#include <compare/check/verdict.h>
#include <compare/engine/engine.h>
#include <compare/scene/named.h>
#include <compare/scene/set_field.h>

namespace plumb::compare {
namespace {

std::vector<Observation> observed(const Scene& scene, const std::vector<std::string>& names) {
    std::vector<Observation> runs;
    for (const Engine& engine : enginesWith(names))
        if (std::ranges::find(names, engine.name) != names.end()) runs.push_back(observe(scene, engine));
    return runs;
}

std::string truthName() {
    return std::ranges::find(knownEngines(), Role::Truth, &Engine::role)->name;
}

/// Also of a metric.
std::optional<double> valueIn(const Scene& scene, const Observation& run, const Observation& truth,
                              const AnswerQuery& query) {
    if (query.kind != AnswerQuery::Kind::Metric) return valueOf(scene, run, query);
    const Measured measured = measure(scene, run, run.role == Role::Truth ? nullptr : &truth, nullptr);
    const auto found = measured.metrics.find(query.name);
    return found == measured.metrics.end() ? std::nullopt : found->second;
}

/// The text with the numbers of a run.
std::string filled(Scene scene, const Observation& run, const Observation& truth, const std::string& text) {
    scene.answer = text;
    return answerOf(scene, run, measure(scene, run, run.role == Role::Truth ? nullptr : &truth, nullptr));
}

/// The runs of the lesson's own engines, which say what is true: the first that knows an answer counts. The closed form
/// comes first, if it is named, then the engine under test.
class Truths {
public:
    explicit Truths(const Lesson& lesson) : scene_(lesson.scene), truth_(observed(scene_, {truthName()}).front()) {
        std::vector<std::string> names = lesson.engines;
        for (const std::string& first : {subjectName(), truthName()})
            std::ranges::stable_partition(names, [&](const std::string& name) { return name == first; });
        for (const std::string& name : names) {
            if (name == truthName())
                runs_.push_back(truth_);
            else
                for (Observation& run : observed(scene_, {name})) runs_.push_back(std::move(run));
        }
    }

    /// Why the closed form does not run, though it is named.
    std::string withoutClosedForm() const {
        for (const Observation& run : runs_)
            if (run.role == Role::Truth) return run.unsupported;
        return "";
    }

    std::optional<double> valueOf(const AnswerQuery& query) const {
        for (const Observation& run : runs_) {
            if (run.states.empty()) continue;
            const std::optional<double> value = valueIn(scene_, run, truth_, query);
            if (value && std::isfinite(*value)) return value;
        }
        return {};
    }
    /// The text with true numbers.
    std::string filled(const std::string& text) const {
        std::string result;
        for (const AnswerPart& part : answerParts(scene_, text, "text")) {
            result += part.text;
            if (!part.query) continue;
            const std::optional<double> value = valueOf(*part.query);
            result += value ? valueText(*value, unitOf(scene_, *part.query)) : "–";
        }
        return result;
    }

private:
    const Scene& scene_;
    Observation truth_;
    std::vector<Observation> runs_{};
};

std::optional<std::string> predictedQuery(const Lesson& lesson) {
    const auto* number = std::get_if<NumberPrediction>(&lesson.predict);
    return number ? std::optional(number->value) : std::nullopt;
}

/// Each once, in the order in which they come.
std::vector<std::string> queriesOf(const Lesson& lesson) {
    std::vector<std::string> queries;
    const auto add = [&](const std::string& query) {
        if (std::ranges::find(queries, query) == queries.end()) queries.push_back(query);
    };
    const auto addFrom = [&](const std::string& text, Marks marks = {}) {
        for (const AnswerPart& part : answerParts(lesson.scene, text, "text", marks))
            if (part.query) add(part.asked);
    };
    if (const auto query = predictedQuery(lesson)) add(*query);
    for (const LessonValue& number : lesson.numbers) add(number.value);
    for (const std::string& line : lesson.formula) addFrom(line, formulaMarks);
    addFrom(lesson.question);
    addFrom(lesson.because);
    for (const LessonQuestion& question : lesson.questions) {
        addFrom(question.ask);
        addFrom(question.answer);
    }
    return queries;
}

WorseResult resultOf(const Lesson& lesson, const WorseCase& worse) {
    WorseResult result{.title = worse.title, .engine = worse.engine};
    const Scene scene = withFields(lesson.scene, settingsOf(worse.set));
    const std::vector<Observation> runs = observed(scene, {worse.engine});
    if (runs.empty()) result.unsupported = "this build does not have it";
    if (runs.empty()) return result;
    result.unsupported = runs.front().unsupported;
    if (runs.front().states.empty()) return result;
    const Observation truth = observed(scene, {truthName()}).front();
    if (const auto query = predictedQuery(lesson))
        result.value = valueIn(scene, runs.front(), truth, answerQuery(scene, *query));
    result.says = filled(scene, runs.front(), truth, worse.says);
    return result;
}

/// Is there a true number, and can it be said?
std::string faultOf(const Lesson& lesson, const LessonResult& result) {
    const auto* predict = std::get_if<NumberPrediction>(&lesson.predict);
    if (!predict) return "";
    const LessonNumber& number = result.numbers.front();
    if (!number.value) return "predict.number.value: " + quoted(predict->value) + " does not happen in the run";
    if (*number.value >= predict->from && *number.value <= predict->to) return "";
    return "predict.number." + std::string(*number.value < predict->from ? "from" : "to") + ": the true value is " +
           valueText(*number.value, number.unit) + ", wanted one between from and to";
}

}  // namespace

LessonResult runLesson(const Lesson& lesson) {
    LessonResult result;
    const Truths truths(lesson);
    for (const std::string& text : queriesOf(lesson)) {
        const AnswerQuery query = answerQuery(lesson.scene, text);
        result.numbers.push_back({text, truths.valueOf(query), unitOf(lesson.scene, query)});
    }
    for (const WorseCase& worse : lesson.worse) result.worse.push_back(resultOf(lesson, worse));
    result.withoutClosedForm = truths.withoutClosedForm();
    result.fault = faultOf(lesson, result);
    result.question = truths.filled(lesson.question);
    result.because = truths.filled(lesson.because);
    for (const LessonQuestion& question : lesson.questions)
        result.asked.push_back(truths.filled(question.ask)), result.answers.push_back(truths.filled(question.answer));
    return result;
}

}  // namespace plumb::compare
