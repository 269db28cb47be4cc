// SPDX-License-Identifier: MIT
#include <compare/scene/schema/schema.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <compare/scene/builtin.h>
#include <compare/scene/json.h>
#include <compare/scene/json_text.h>
#include <compare/scene/set_field.h>

#include "catch.h"
#include "compare/command/called.h"
#include "house/shell.h"

namespace plumb::compare {
namespace {

bool hasValidator() {
    const bool has = test::shell("python3 -c 'import jsonschema' 2>/dev/null").ok;
    if (!has) WARN("not tested: python3-jsonschema is not installed");
    return has;
}

/// The field of each text that the schema refuses, "-" for none.
std::vector<std::string> refusedBySchema(const std::vector<std::string>& texts) {
    const Folder folder("plumb_schema_test");
    const auto put = [&](const std::string& name, const std::string& text) {
        std::ofstream(folder / name, std::ios::binary) << text;
        return test::quoted(folder / name);
    };
    std::string command = "python3 " + test::quoted(PLUMB_SOURCE_DIR "/tests/compare/scene/schema/refused.py");
    command += " " + put("schema.json", sceneSchema());
    for (std::size_t i = 0; i < texts.size(); ++i) command += " " + put(std::to_string(i) + ".json", texts[i]);
    std::istringstream lines(test::shell(command + " 2>&1").output);
    std::vector<std::string> fields;
    for (std::string line; std::getline(lines, line);) fields.push_back(line);
    return fields;
}

/// The field that the reader refuses, "-" for none.
std::string refusedByReader(const std::string& text) {
    try {
        fromJson(text, "f.json");
    } catch (const std::invalid_argument& error) {
        std::string what = error.what();
        what = what.substr(what.find(": ") + 2);  // file and line
        return what.substr(0, what.find(": "));
    }
    return "-";
}

/// A scene of a ball, a ground, a hinge between them, and what else is given.
std::string sceneWith(const std::string& ball, const std::string& scene = "", const std::string& joint = "") {
    return R"({"name": "a", )" + scene + R"("bodies": [{"name": "ground", "type": "static"}, {"name": "ball", )" +
           ball + R"("shapes": [{"circle": {"radius": 0.5}}]}], "joints": [{"name": "j", "bodyA": "ground", )" +
           (joint.empty() ? R"("bodyB": "ball", "revolute": {})" : joint) + "}]}";
}

/// Each has one fault.
std::vector<std::string> brokenScenes() {
    const std::string hinge = R"("bodyB": "ball", "revolute": )";
    return {
        sceneWith("", R"("colour": 3, )"),
        sceneWith("", R"("dt": 0, )"),
        sceneWith("", R"("dt": "fast", )"),
        sceneWith("", R"("duration": -1, )"),
        sceneWith("", R"("gravity": 9.81, )"),
        sceneWith("", R"("sleeping": 1, )"),
        sceneWith("", R"("wrap": {"width": 0}, )"),
        sceneWith("", R"("checks": [{"agree": {"tolerance": 0}}], )"),
        sceneWith("", R"("probes": [{"name": "p", "angle": {"body": "ball"}, "from": -1}], )"),
        sceneWith("", R"("probes": [{"name": "p", "angle": {"body": "ball"}, "watch": "all"}], )"),
        sceneWith("", R"("closedForm": {"bodies": []}, )"),
        sceneWith("", R"("closedForm": {"bodies": [{"damped": {"body": "ball", "damping": 0}}]}, )"),
        sceneWith("", R"("closedForm": {"bodies": [{"free": {"body": "ball", "shortestFlight": 0}}]}, )"),
        sceneWith("", R"("closedForm": {"bodies": [{"swings": {"body": "ball"}}]}, )"),
        sceneWith("", R"("fields": [{"name": "", "drag": {"linear": 1}}], )"),
        sceneWith(R"("type": "kinematic", )",
                  R"("movers": [{"name": "m", "body": "ball", "slide": {"pushStrength": -1}}], )"),
        sceneWith(R"("postion": [0, 1], )"),
        sceneWith(R"("type": "statc", )"),
        sceneWith(R"("linearDamping": -1, )"),
        sceneWith(R"("mass": -1, )"),
        sceneWith(R"("appears": -1, )"),
        sceneWith(R"("tag": -1, )"),
        sceneWith("", "", hinge + R"({"limit": {"upper": "endless"}})"),
        sceneWith("", "", hinge + R"({"maxMotorTorque": -1})"),
        sceneWith("", "", hinge + R"({"motorSpeed": 1e16})"),
        sceneWith("", "", R"("revolute": {})"),
        R"({"name": "a b", "bodies": [{"name": "b"}]})",
        R"({"name": "a", "bodies": []})",
        R"({"name": "a", "bodies": [{"name": ""}]})",
        R"({"name": "a", "bodies": [{"name": "b", "shapes": [{"circle": {"radius": -1}}]}]})",
        R"({"name": "a", "bodies": [{"name": "b", "shapes": [{"circle": {}, "material": {"restitution": 2}}]}]})",
        R"({"name": "a", "bodies": [{"name": "b", "shapes": [{"circle": {}, "filter": {"group": 1.5}}]}]})",
        R"({"name": "a", "bodies": [{"name": "b", "shapes": [{"circle": {}, "capsule": {}}]}]})",
        R"({"name": "a", "bodies": [{"name": "b", "shapes": [{"circle": {}, "oneWay": [0, 0]}]}]})",
    };
}

}  // namespace

TEST_CASE("the schema accepts every built-in scene, with its defaults and without", "[compare][scene][schema]") {
    if (!hasValidator()) return;
    std::vector<std::string> texts, names;
    for (const Scene& scene : builtinScenes()) {
        for (const Defaults defaults : {Defaults::LeftOut, Defaults::Written}) {
            texts.push_back(toJson(scene, defaults));
            names.push_back(scene.name);
        }
    }
    texts.push_back(sceneWith(R"("mass": 3, )"));
    names.push_back("a ball of 3 kg");
    const std::vector<std::string> refused = refusedBySchema(texts);
    REQUIRE(refused.size() == texts.size());
    for (std::size_t i = 0; i < refused.size(); ++i) {
        INFO(names[i]);
        CHECK(refused[i] == "-");
    }
}

TEST_CASE("the schema refuses 34 broken scenes at the fields at which the reader refuses them",
          "[compare][scene][schema]") {
    if (!hasValidator()) return;
    const std::vector<std::string> texts = brokenScenes();
    REQUIRE(texts.size() == 34);
    const std::vector<std::string> refused = refusedBySchema(texts);
    REQUIRE(refused.size() == texts.size());
    for (std::size_t i = 0; i < texts.size(); ++i) {
        INFO(texts[i]);
        CHECK(refused[i] == refusedByReader(texts[i]));
        CHECK(refused[i] != "-");
    }
}

TEST_CASE("a scene with every default written reads back as the scene without", "[compare][scene][schema]") {
    for (const Scene& scene : builtinScenes()) {
        INFO(scene.name);
        CHECK(toJson(fromJson(toJson(scene, Defaults::Written), "f.json")) == toJson(scene));
    }
}

TEST_CASE("every field in the schema has a meaning, and the page has a row for it", "[compare][scene][schema]") {
    const Json schema = Json::parse(sceneSchema());
    const std::string page = sceneSchemaPage();
    for (const auto& [part, object] : schema["$defs"].items()) {
        CHECK(page.find("\n## " + part + "\n") != std::string::npos);
        for (const auto& [name, field] : object["properties"].items()) {
            INFO(part << "." << name);
            CHECK(page.find("`" + name + "`") != std::string::npos);
            const bool isAlternative = field.size() == 1 && field.contains("$ref");
            CHECK((isAlternative || !field["description"].get<std::string>().empty()));
        }
    }
    CHECK(page.find("| `dt` | number | s | `0.016666666666666666` | > 0 | length of a step |") != std::string::npos);
}

}  // namespace plumb::compare
