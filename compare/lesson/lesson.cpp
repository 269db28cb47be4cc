// SPDX-License-Identifier: MIT
#include <compare/lesson/lesson.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include <compare/engine/engine.h>
#include <compare/lesson/fields.h>
#include <compare/scene/bench.h>
#include <compare/scene/builtin.h>
#include <compare/scene/crowd.h>
#include <compare/scene/json_reader.h>
#include <compare/scene/json_value.h>
#include <compare/scene/json_writer.h>
#include <compare/scene/named.h>
#include <compare/scene/set_field.h>

namespace plumb::compare {
namespace {

constexpr const char* sceneField = "scene";

/// The message of what act refuses begins with the field.
template <class Act>
auto inField(const std::string& field, const Act& act) {
    try {
        return act();
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(field + ": " + error.what());
    }
}

Scene sceneNamed(const std::string& name) {
    if (std::optional<Scene> scene = findScene(name)) return *std::move(scene);
    if (std::optional<Scene> scene = crowdScene(name)) return *std::move(scene);
    const std::vector<BenchScene> found = findBenchScenes(name);
    if (found.size() == 1) return found.front().build();
    requireKnown(name, namesOf(builtinScenes()), sceneField, "a scene");
    return {};
}

Scene baseFrom(const Json& given) {
    if (given.is_string()) return sceneNamed(given.get<std::string>());
    if (!given.is_object()) refuseKind(sceneField, given, "the name of a scene, or a scene");
    return inField(sceneField, [&] { return sceneOf(given); });
}

std::vector<FieldSetting> settingsOf(const std::vector<std::string>& texts) {
    std::vector<FieldSetting> settings;
    for (const std::string& text : texts) settings.push_back(fieldSettingOf(text));
    return settings;
}

/// The scene as the lesson has it. What its author expected and answered holds for the scene as it was.
Scene sceneOf(const Lesson& lesson, Scene base) {
    base.checks.clear();
    base.answer.clear();
    base.title = lesson.title;
    base.question = lesson.question;
    base.controls = lesson.controls;
    Scene scene = inField("set", [&] { return withFields(std::move(base), settingsOf(lesson.set)); });
    validateEngineNames(scene);
    return scene;
}

void requireEngine(const std::string& name, const std::string& field) {
    requireKnown(name, namesOf(knownEngines()), field, "an engine");
}

std::vector<AnswerPart> partsBetween(char open, char close, const Scene& scene, const std::string& text,
                                     const std::string& field) {
    std::vector<AnswerPart> parts;
    std::size_t start = 0;
    for (std::size_t at = text.find(open); at != std::string::npos; at = text.find(open, start)) {
        const std::size_t end = text.find(close, at);
        if (end == std::string::npos) refuse(field, std::string("a ") + open + " is not closed");
        const std::string inside = text.substr(at + 1, end - at - 1);
        parts.push_back({text.substr(start, at - start), inField(field, [&] { return answerQuery(scene, inside); })});
        start = end + 1;
    }
    parts.push_back({text.substr(start), {}});
    return parts;
}

/// A curve or a chart is of a quantity: "y of ball".
void requireQuantity(const Scene& scene, const std::string& text, const std::string& field) {
    const AnswerQuery query = inField(field, [&] { return answerQuery(scene, text); });
    if (query.kind != AnswerQuery::Kind::Value || query.when)
        refuse(field, quoted(text) + " is no quantity over time, as y of ball is");
}

/// A chart that is about all bodies together.
bool isOfTheWhole(const std::string& chart) {
    return chart == "energy" || chart == "error" || chart == "causes";
}

void validate(const NumberPrediction& predict, const Scene& scene, const std::string& field) {
    inField(field + ".value", [&] { return answerQuery(scene, predict.value); });
    if (!(predict.from < predict.to))
        refuse(field + ".to", toText(predict.to) + " is not above from, " + toText(predict.from));
}
void validate(const ChoicePrediction& predict, const Scene&, const std::string& field) {
    const auto count = static_cast<int>(predict.options.size());
    if (count < 2) refuse(field + ".options", std::to_string(count) + " of them, wanted at least 2");
    if (predict.right < 1 || predict.right > count)
        refuse(field + ".right",
               std::to_string(predict.right) + " is not one of the options, from 1 to " + std::to_string(count));
}
void validate(const CurvePrediction& predict, const Scene& scene, const std::string& field) {
    requireQuantity(scene, predict.value, field + ".value");
}

void validateWorse(const Lesson& lesson, std::size_t index) {
    const std::string field = at("worse", index);
    const WorseCase& worse = lesson.worse[index];
    requireEngine(worse.engine, field + ".engine");
    const Scene scene = inField(field + ".set", [&] { return withFields(lesson.scene, settingsOf(worse.set)); });
    (void)textParts(scene, worse.says, field + ".says");
}

void validateTexts(const Lesson& lesson) {
    const std::pair<const char*, const std::string*> texts[] = {{"title", &lesson.title},
                                                                {"about", &lesson.about},
                                                                {"question", &lesson.question},
                                                                {"because", &lesson.because}};
    for (const auto& [field, text] : texts) {
        if (text->empty()) refuse(field, "is not given");
        (void)textParts(lesson.scene, *text, field);
    }
    for (std::size_t i = 0; i < lesson.formula.size(); ++i)
        (void)formulaParts(lesson.scene, lesson.formula[i], at("formula", i));
    if (lesson.questions.empty()) refuse("questions", "there is none, wanted at least one");
    for (std::size_t i = 0; i < lesson.questions.size(); ++i) {
        if (lesson.questions[i].ask.empty()) refuse(at("questions", i) + ".ask", "is not given");
        (void)textParts(lesson.scene, lesson.questions[i].ask, at("questions", i) + ".ask");
        (void)textParts(lesson.scene, lesson.questions[i].answer, at("questions", i) + ".answer");
    }
}

void validate(const Lesson& lesson) {
    const bool isName = !lesson.name.empty() && std::ranges::all_of(lesson.name, [](unsigned char c) {
        return std::islower(c) || std::isdigit(c) || c == '_';
    });
    if (!isName) refuse("name", quoted(lesson.name) + " is not made of small letters, digits and underscores");
    if (lesson.engines.empty()) refuse("engines", "there is none, wanted at least one");
    for (std::size_t i = 0; i < lesson.engines.size(); ++i) requireEngine(lesson.engines[i], at("engines", i));
    std::visit(
        [&](const auto& predict) {
            validate(predict, lesson.scene, std::string("predict.") + predictionTags[lesson.predict.index()]);
        },
        lesson.predict);
    for (std::size_t i = 0; i < lesson.charts.size(); ++i)
        if (!isOfTheWhole(lesson.charts[i].value))
            requireQuantity(lesson.scene, lesson.charts[i].value, at("charts", i) + ".value");
    for (std::size_t i = 0; i < lesson.numbers.size(); ++i)
        inField(at("numbers", i) + ".value", [&] { return answerQuery(lesson.scene, lesson.numbers[i].value); });
    // A path that does not exist is found by setting its own value.
    for (std::size_t i = 0; i < lesson.controls.size(); ++i)
        for (const std::string& path : lesson.controls[i].set)
            if (path.find(':') == std::string::npos)
                inField(at("controls", i) + ".set", [&] { return textAt(lesson.scene, path); });
    for (std::size_t i = 0; i < lesson.worse.size(); ++i) validateWorse(lesson, i);
    validateTexts(lesson);
}

}  // namespace

std::vector<AnswerPart> textParts(const Scene& scene, const std::string& text, const std::string& field) {
    return partsBetween('{', '}', scene, text, field);
}

std::vector<AnswerPart> formulaParts(const Scene& scene, const std::string& formula, const std::string& field) {
    return partsBetween('<', '>', scene, formula, field);
}

Lesson lessonFromJson(std::string_view text, const std::string& file) {
    const JsonText json = parseJson(text, file);
    try {
        if (!json.root.is_object()) refuseKind("", json.root, "an object");
        Json rest = json.root;
        if (!rest.contains(sceneField)) refuse(sceneField, "is not given, wanted the name of a scene, or a scene");
        rest.erase(sceneField);
        Lesson lesson = JsonReader::read(JsonType<Lesson>(), rest, "");
        lesson.scene = sceneOf(lesson, baseFrom(json.root[sceneField]));
        validate(lesson);
        return lesson;
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(withLine(json, file, error.what()));
    }
}

std::string toJson(const Lesson& lesson) {
    return formatJson(JsonWriter(Defaults::Written).write(lesson));
}

}  // namespace plumb::compare
