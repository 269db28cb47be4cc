// SPDX-License-Identifier: MIT
#include <compare/command/lesson_command.h>

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <optional>
#include <stdexcept>

#include <compare/command/output_file.h>
#include <compare/lesson/lesson_run.h>
#include <compare/scene/json_reader.h>
#include <compare/scene/json_text.h>
#include <compare/scene/scene_file.h>

namespace plumb::compare {
namespace {

std::string valueText(const std::optional<double>& value, const std::string& unit) {
    if (!value) return "–";
    return fmt::format("{:.6g}{}{}", *value, unit.empty() ? "" : " ", unit);
}

Json jsonOf(const std::optional<double>& value) {
    return value ? Json(*value) : Json();
}

void print(const Lesson& lesson, const LessonResult& result, std::ostream& out) {
    fmt::print(out, "{}: {}\n  {}\n", lesson.name, lesson.title, result.question);
    for (const LessonNumber& number : result.numbers)
        fmt::print(out, "  {}: {}\n", number.query, valueText(number.value, number.unit));
    if (!result.withoutClosedForm.empty())
        fmt::print(out, "  the closed form does not run, so the next engine answers: {}\n", result.withoutClosedForm);
    fmt::print(out, "  because: {}\n", result.because);
    for (const WorseResult& worse : result.worse)
        fmt::print(out, "  worse: {}: {}\n", worse.title, worse.unsupported.empty() ? worse.says : worse.unsupported);
    for (std::size_t i = 0; i < result.answers.size(); ++i)
        fmt::print(out, "  {} {}\n", result.asked[i], result.answers[i]);
}

Json jsonOf(const Lesson& lesson, const LessonResult& result) {
    Json data{{"name", lesson.name},      {"title", lesson.title},  {"slides", lesson.slides},
              {"numbers", Json::array()}, {"worse", Json::array()}, {"because", result.because},
              {"answers", result.answers}};
    for (const LessonNumber& number : result.numbers)
        data["numbers"].push_back({{"query", number.query}, {"value", jsonOf(number.value)}, {"unit", number.unit}});
    for (const WorseResult& worse : result.worse) {
        data["worse"].push_back({{"title", worse.title}, {"engine", worse.engine}, {"value", jsonOf(worse.value)}});
        if (worse.unsupported.empty())
            data["worse"].back()["says"] = worse.says;
        else
            data["worse"].back()["unsupported"] = worse.unsupported;
    }
    return data;
}

}  // namespace

void runLessons(const Arguments& arguments, std::ostream& out) {
    std::optional<OutputFile> json;
    if (arguments.json) json.emplace("--json", *arguments.json);
    Json data{{"schema", 1}, {"lessons", Json::array()}};
    for (const std::string& path : arguments.scenes) {
        const std::string text = readText(path, "a lesson's JSON file");
        const Lesson lesson = lessonFromJson(text, path);
        const LessonResult result = runLesson(lesson);
        if (!result.fault.empty()) throw std::invalid_argument(withLine(parseJson(text, path), path, result.fault));
        print(lesson, result, out);
        data["lessons"].push_back(jsonOf(lesson, result));
    }
    if (json) json->write(data.dump(2) + "\n");
}

}  // namespace plumb::compare
