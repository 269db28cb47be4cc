// SPDX-License-Identifier: MIT
#include <compare/lesson/lesson.h>

#include <stdexcept>

#include <compare/engine/engine.h>
#include <compare/lesson/fields.h>
#include <compare/lesson/lesson_check.h>
#include <compare/scene/bench.h>
#include <compare/scene/builtin.h>
#include <compare/scene/crowd.h>
#include <compare/scene/in_field.h>
#include <compare/scene/json_reader.h>
#include <compare/scene/json_value.h>
#include <compare/scene/json_writer.h>
#include <compare/scene/named.h>
#include <compare/scene/set_field.h>

namespace plumb::compare {
namespace {

constexpr const char* sceneField = "scene";

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
    return inField(
        sceneField, [&] { return sceneOf(given); }, ".");
}

/// The scene as the lesson has it. What its author expected and answered holds for the scene as it was.
Scene sceneOf(const Lesson& lesson, Scene base) {
    base.checks.clear();
    base.answer.clear();
    base.controls.clear();
    Scene scene = inField("set", [&] { return withFields(std::move(base), settingsOf(lesson.set)); });
    scene.title = lesson.title;
    scene.question = lesson.question;
    scene.controls = lesson.controls;
    validate(scene);
    return scene;
}

}  // namespace

std::vector<FieldSetting> settingsOf(const std::vector<std::string>& texts) {
    std::vector<FieldSetting> settings;
    for (const std::string& text : texts) settings.push_back(fieldSettingOf(text));
    return settings;
}

Lesson lessonFromJson(std::string_view text, const std::string& file) {
    const JsonText json = parseJson(text, file);
    try {
        if (!json.root.is_object()) refuseKind("", json.root, "an object");
        Json rest = json.root;
        if (!rest.contains(sceneField)) refuse(sceneField, "is not given, wanted the name of a scene, or a scene");
        if (!rest.contains("predict")) refuse("predict", "is not given, wanted a number, a choice or a curve");
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
