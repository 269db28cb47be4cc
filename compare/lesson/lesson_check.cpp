// SPDX-License-Identifier: MIT
#include <compare/lesson/lesson_check.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <optional>

#include <compare/check/answer.h>
#include <compare/engine/engine.h>
#include <compare/engine/engine_settings.h>
#include <compare/lesson/fields.h>
#include <compare/scene/in_field.h>
#include <compare/scene/json_text.h>
#include <compare/scene/named.h>
#include <compare/scene/set_field.h>

namespace plumb::compare {
namespace {

void requireEngine(const std::string& name, const std::string& field) {
    requireKnown(name, namesOf(knownEngines()), field, "an engine");
}

/// A curve or a chart is of a quantity: "y of ball".
void requireQuantity(const Scene& scene, const std::string& text, const std::string& field) {
    const AnswerQuery query = answerQuery(scene, text, field);
    if (query.kind != AnswerQuery::Kind::Value || query.when)
        refuse(field, quoted(text) + " is no quantity over time, as y of ball is");
}

/// A chart that is about all bodies together.
bool isOfTheWhole(const std::string& chart) {
    return chart == "energy" || chart == "error" || chart == "causes";
}

/// The unit is that of the query, as it is written on a page: "°" for degrees.
void requireUnit(const Scene& scene, const std::string& query, const std::string& unit, const std::string& field) {
    std::string wanted = unitOf(scene, answerQuery(scene, query, field + ".value"));
    if (wanted == "-") wanted = "";
    if (unit == wanted || (unit == "°" && wanted == "deg") || (unit == "m/s²" && wanted == "m/s^2")) return;
    refuse(field + ".unit", quoted(unit) + ", but " + quoted(query) + " is read " +
                                (wanted.empty() ? "without a unit" : "in " + wanted));
}

/// A share above 1 was meant as per cent.
void requireShare(double within, const std::string& field) {
    if (within > 1) refuse(field + ".within", toText(within) + " is more than the whole: 0.03 is 3 per cent");
}

void validate(const NumberPrediction& predict, const Lesson& lesson, const std::string& field) {
    requireUnit(lesson.scene, predict.value, predict.unit, field);
    requireShare(predict.within, field);
    if (!(predict.from < predict.to))
        refuse(field + ".to", toText(predict.to) + " is not above from, " + toText(predict.from));
    if (!predict.tries.empty()) {
        std::vector<std::string> labels;
        for (const SceneControl& control : lesson.controls) labels.push_back(control.label);
        requireKnown(predict.tries, labels, field + ".tries", "a control");
    }
}
void validate(const ChoicePrediction& predict, const Lesson&, const std::string& field) {
    const auto count = static_cast<int>(predict.options.size());
    if (count < 2) refuse(field + ".options", std::to_string(count) + " of them, wanted at least 2");
    if (predict.right < 1 || predict.right > count)
        refuse(field + ".right",
               std::to_string(predict.right) + " is not one of the options, from 1 to " + std::to_string(count));
}
void validate(const CurvePrediction& predict, const Lesson& lesson, const std::string& field) {
    requireQuantity(lesson.scene, predict.value, field + ".value");
    requireUnit(lesson.scene, predict.value, predict.unit, field);
    requireShare(predict.within, field);
}

/// What is set for one engine alone must be for one of these, and something that may differ. scene: with all settings.
void requireOwnSettings(const Scene& scene, const std::vector<FieldSetting>& settings,
                        const std::vector<std::string>& engines, const std::string& field) {
    for (const FieldSetting& setting : settings) {
        const std::size_t colon = setting.path.find(':');
        if (colon == std::string::npos) continue;
        const std::string engine = setting.path.substr(0, colon);
        if (std::ranges::find(engines, engine) == engines.end())
            refuse(field, quoted(engine) + " before the colon is no engine of it, which are " + listText(engines));
        inField(field, [&] { return sceneFor(engine, scene); });
    }
}

void validateWorse(const Lesson& lesson, std::size_t index) {
    const std::string field = at("worse", index);
    const WorseCase& worse = lesson.worse[index];
    requireEngine(worse.engine, field + ".engine");
    const std::vector<FieldSetting> settings = inField(field + ".set", [&] { return settingsOf(worse.set); });
    const Scene scene = inField(field + ".set", [&] { return withFields(lesson.scene, settings); });
    requireOwnSettings(scene, settings, {worse.engine}, field + ".set");
    (void)answerParts(scene, worse.says, field + ".says");
}

bool isVector(ShownAs as) {
    return as == ShownAs::X || as == ShownAs::Y || as == ShownAs::Size || as == ShownAs::Direction ||
           as == ShownAs::Hanging;
}

double shownOf(const Vec2& v, ShownAs as) {
    const double degrees = std::atan2(v.y(), v.x()) * 180 / std::numbers::pi;
    switch (as) {
        case ShownAs::X: return v.x();
        case ShownAs::Y: return v.y();
        case ShownAs::Direction: return degrees;
        case ShownAs::Hanging: return std::remainder(degrees + 90, 360);
        default: return v.norm();
    }
}

double shownOf(double value, ShownAs as) {
    switch (as) {
        case ShownAs::Downwards: return -value;
        case ShownAs::PerSecond: return std::round(1 / value);
        case ShownAs::Degrees: return value * 180 / std::numbers::pi;
        case ShownAs::DegreesDown: return -value * 180 / std::numbers::pi;
        default: return value;
    }
}

/// As which number a control shows what its first path holds; none for one engine's own number, which a scene may leave
/// out. The path must hold what SceneControl::as reads.
std::optional<double> shownBy(const Scene& scene, const SceneControl& control) {
    const std::string& path = control.set.front();
    if (path.find(':') != std::string::npos) return {};
    const Json held = Json::parse(textAt(scene, path));
    const bool isPair = held.is_array() && held.size() == 2 && held[0].is_number() && held[1].is_number();
    if (isPair != isVector(control.as))
        refuse(path, "holds " + held.dump() + ", wanted " +
                         (isPair ? "x, y, size, direction or hanging, as it is a vector" : "a field that is a vector"));
    if (isPair) return shownOf(Vec2(held[0].get<double>(), held[1].get<double>()) - control.about, control.as);
    return shownOf(numberAt(scene, path), control.as);
}

void validateControl(const Scene& scene, const SceneControl& control, const std::string& field) {
    // A path that does not exist is found by reading its value.
    for (const std::string& path : control.set)
        if (path.find(':') == std::string::npos) inField(field + ".set", [&] { return textAt(scene, path); });
    if (control.step > control.to - control.from)
        refuse(field + ".step",
               toText(control.step) + " is more than from " + toText(control.from) + " to " + toText(control.to));
    const std::optional<double> shown = inField(field + ".as", [&] { return shownBy(scene, control); });
    if (!shown) return;
    const double near = 1e-6 * std::max(1.0, std::abs(*shown));
    if (*shown < control.from - near)
        refuse(field + ".from", toText(control.from) + " is above what the lesson begins with, " + toText(*shown));
    if (*shown > control.to + near)
        refuse(field + ".to", toText(control.to) + " is below what the lesson begins with, " + toText(*shown));
}

void validateTexts(const Lesson& lesson) {
    const std::pair<const char*, const std::string*> texts[] = {{"title", &lesson.title},
                                                                {"about", &lesson.about},
                                                                {"question", &lesson.question},
                                                                {"because", &lesson.because}};
    for (const auto& [field, text] : texts) {
        if (text->empty()) refuse(field, "is not given");
        (void)answerParts(lesson.scene, *text, field);
    }
    for (std::size_t i = 0; i < lesson.formula.size(); ++i)
        (void)answerParts(lesson.scene, lesson.formula[i], at("formula", i), formulaMarks);
    if (lesson.questions.empty()) refuse("questions", "there is none, wanted at least one");
    for (std::size_t i = 0; i < lesson.questions.size(); ++i) {
        if (lesson.questions[i].ask.empty()) refuse(at("questions", i) + ".ask", "is not given");
        (void)answerParts(lesson.scene, lesson.questions[i].ask, at("questions", i) + ".ask");
        (void)answerParts(lesson.scene, lesson.questions[i].answer, at("questions", i) + ".answer");
    }
}

std::vector<std::string> enginesOf(const Lesson& lesson) {
    std::vector<std::string> names = lesson.engines;
    for (const WorseCase& worse : lesson.worse) names.push_back(worse.engine);
    return names;
}

}  // namespace

void validate(const Lesson& lesson) {
    const bool isName = !lesson.name.empty() && std::ranges::all_of(lesson.name, [](unsigned char c) {
        return std::islower(c) || std::isdigit(c) || c == '_';
    });
    if (!isName) refuse("name", quoted(lesson.name) + " is not made of small letters, digits and underscores");
    if (lesson.engines.empty()) refuse("engines", "there is none, wanted at least one");
    for (std::size_t i = 0; i < lesson.engines.size(); ++i) requireEngine(lesson.engines[i], at("engines", i));
    std::visit(
        [&](const auto& predict) {
            validate(predict, lesson, std::string("predict.") + predictionTags[lesson.predict.index()]);
        },
        lesson.predict);
    for (std::size_t i = 0; i < lesson.charts.size(); ++i)
        if (!isOfTheWhole(lesson.charts[i].value))
            requireQuantity(lesson.scene, lesson.charts[i].value, at("charts", i) + ".value");
    for (std::size_t i = 0; i < lesson.numbers.size(); ++i)
        (void)answerQuery(lesson.scene, lesson.numbers[i].value, at("numbers", i) + ".value");
    for (std::size_t i = 0; i < lesson.controls.size(); ++i)
        validateControl(lesson.scene, lesson.controls[i], at("controls", i));
    requireOwnSettings(lesson.scene, settingsOf(lesson.set), enginesOf(lesson), "set");
    for (std::size_t i = 0; i < lesson.worse.size(); ++i) validateWorse(lesson, i);
    validateTexts(lesson);
}

}  // namespace plumb::compare
