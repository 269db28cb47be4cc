// SPDX-License-Identifier: MIT
#include <compare/scene/json.h>
#include <compare/scene/scene_file.h>

#include <filesystem>
#include <fstream>
#include <functional>

#include <compare/scene/builtin.h>

#include "catch.h"

namespace plumb::compare {
namespace {

std::string messageOf(const std::function<void()>& action) {
    try {
        action();
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "no complaint";
}

std::string jsonComplaint(const std::string& text) {
    return messageOf([&] { fromJson(text, "f.json"); });
}

/// A scene of one body, which begins on the second line.
std::string withBody(const std::string& fields) {
    return "{\"name\": \"a\", \"bodies\": [\n{\"name\": \"b\", " + fields + "}]}";
}

}  // namespace

TEST_CASE("a field of a material that stands in a body or a shape is refused with its place",
          "[compare][scene][errors]") {
    CHECK(jsonComplaint(withBody("\"density\": 2")) ==
          "f.json:2: bodies[0].density: unknown field, it belongs to the material of a shape: "
          "shapes[0].material.density");
    CHECK(jsonComplaint(withBody("\"shapes\": [{\"circle\": {}, \"friction\": 1}]")) ==
          "f.json:2: bodies[0].shapes[0].friction: unknown field, it belongs to the material of a shape: "
          "material.friction");
}

TEST_CASE("a field that a world would refuse is refused with its place", "[compare][scene][fields]") {
    const auto with = [](const std::string& field) {
        return jsonComplaint(
            "{\"name\": \"a\", \"bodies\": [{\"name\": \"b\", \"shapes\": [{\"circle\": {}}]}], \"fields\": [\n" +
            field + "]}");
    };
    CHECK(with(R"({"name": "x", "attractor": {"power": 9}})").starts_with("f.json:2: fields[0]: Attractor.power: 9"));
    CHECK(with(R"({"name": "x", "magnet": {}, "body": "c"})").starts_with("f.json:2: fields[0].body: \"c\" is not"));
    CHECK(with(R"({"name": "x", "drag": {}, "body": "b"})").starts_with("f.json:2: fields[0].body: \"b\" carries"));
    CHECK(with(R"({"name": "x", "wind": {}})").starts_with("f.json:2: fields[0].wind: unknown field"));
    CHECK(with(R"({"name": "x", "drag": {}, "region": {"segment": {}}})").find("a line has no area") !=
          std::string::npos);
}

TEST_CASE("text that is not JSON is refused with its line and column", "[compare][scene][errors]") {
    CHECK(jsonComplaint("{\"name\": \"a\",\n \"dt\": 0.1\n \"duration\": 2}") ==
          "f.json:3:2: syntax error while parsing object - unexpected string literal; expected '}'");
    CHECK(jsonComplaint("{\"name\": \"a\",\n \"dt\": 1,\n}\n") ==
          "f.json:3:1: syntax error while parsing object key - unexpected '}'; expected string literal");
    CHECK(jsonComplaint("{\n \"dt\": 01}") ==
          "f.json:2:9: syntax error while parsing object - unexpected number literal; expected '}'");
    CHECK(jsonComplaint("{\n \"dt\": true false}") ==
          "f.json:2:13: syntax error while parsing object - unexpected false literal; expected '}'");
    CHECK(jsonComplaint("{\n \"dt\": NaN}") == "f.json:2:8: syntax error while parsing value - invalid literal");
    CHECK(jsonComplaint("{\n \"dt\": 1e999}") == "f.json:2:8: number overflow parsing '1e999'");
    CHECK(jsonComplaint("{\n \"dt\": 1").starts_with("f.json:2:9: "));
    CHECK(jsonComplaint("").starts_with("f.json:1:1: "));
    CHECK(jsonComplaint("{}\n x").starts_with("f.json:2:2: "));
    CHECK(jsonComplaint("{\"name\": \"a\nb\"}").starts_with("f.json:1:12: "));
    CHECK(jsonComplaint(std::string(100000, '[')) == "f.json:1:65: nested 65 deep, wanted at most 64");
}

TEST_CASE("a field given twice is refused where it stands the second time", "[compare][scene][errors]") {
    CHECK(jsonComplaint("{\"dt\": 1,\n \"dt\": 1}") == "f.json:2:2: dt: given twice, wanted once");
    CHECK(jsonComplaint("{\"bodies\": [{},\n {\"angle\": 1, \"angle\": 1}]}") ==
          "f.json:2:15: bodies[1].angle: given twice, wanted once");
}

TEST_CASE("an unknown field is refused with the nearest known one and those that are known",
          "[compare][scene][errors]") {
    CHECK(jsonComplaint("{\n\"nmae\": \"a\"}") ==
          "f.json:2: nmae: unknown field, the nearest known one is name; known are "
          "name, title, group, question, answer, gravity, duration, dt, sleeping, bodies, joints, fields, ...");
    CHECK(
        jsonComplaint(withBody("\n\"postion\": [0, 1]"))
            .starts_with("f.json:3: bodies[0].postion: unknown field, the nearest known one is position; known are "));
    CHECK(jsonComplaint(withBody(R"("shapes": [{"circel": {}}])")) ==
          "f.json:2: bodies[0].shapes[0].circel: unknown field, the nearest known one is circle; known are box, "
          "circle, capsule, polygon, segment, chain, tiles, material, filter, sensor, oneWay, tag");
    CHECK(jsonComplaint(withBody(R"("shapes": [{"box": {"size": [1, 1]}}])")) ==
          "f.json:2: bodies[0].shapes[0].box.size: unknown field, the nearest known one is halfSize; known are "
          "halfSize, center, radius");
}

TEST_CASE("a value of the wrong kind is refused with what was wanted", "[compare][scene][errors]") {
    CHECK(jsonComplaint("[1]") == "f.json:1: scene: [1] is not an object");
    CHECK(jsonComplaint("{\"name\": null}") == "f.json:1: name: null is not a text");
    CHECK(jsonComplaint("{\"name\": \"a\",\n\"dt\": \"fast\"}") == "f.json:2: dt: \"fast\" is not a number");
    CHECK(jsonComplaint("{\"bodies\": {}}") == "f.json:1: bodies: {} is not a list");
    CHECK(jsonComplaint(withBody("\"position\": 3")) == "f.json:2: bodies[0].position: 3 is not two numbers [x, y]");
    CHECK(jsonComplaint(withBody("\"position\": [1,\n\"x\"]")) ==
          "f.json:3: bodies[0].position[1]: \"x\" is not a number");
    CHECK(jsonComplaint(withBody("\"canSleep\": 1")) == "f.json:2: bodies[0].canSleep: 1 is not true or false");
    CHECK(jsonComplaint(withBody("\"type\": \"statc\"")) ==
          "f.json:2: bodies[0].type: \"statc\" is not static, kinematic or dynamic");
    CHECK(jsonComplaint(withBody(R"("shapes": [{"circle": {}, "filter": {"mask": -1}}])")) ==
          "f.json:2: bodies[0].shapes[0].filter.mask: -1 is not a whole number from 0 to 2^64 - 1");
    CHECK(jsonComplaint(withBody(R"("shapes": [{"circle": {}, "polygon": {}}])")) ==
          "f.json:2: bodies[0].shapes[0]: has both circle and polygon, wanted one of them");
    CHECK(jsonComplaint(withBody(R"("shapes": [{"segment": {}, "box": {}}])")) ==
          "f.json:2: bodies[0].shapes[0]: has both box and segment, wanted one of them");
    CHECK(jsonComplaint(withBody(R"("shapes": [{"material": {}}])")) ==
          "f.json:2: bodies[0].shapes[0]: does not say of what kind it is, wanted circle, capsule, polygon, segment, "
          "chain or tiles");
    CHECK(jsonComplaint(withBody(R"("shapes": [{"circle": {}, "filter": {"group": 2147483648}}])")) ==
          "f.json:2: bodies[0].shapes[0].filter.group: 2147483648 is not a whole number of 32 bits");
    CHECK(jsonComplaint(withBody(R"("shapes": [{"circle": {}, "filter": {"group": 1.5}}])")) ==
          "f.json:2: bodies[0].shapes[0].filter.group: 1.5 is not a whole number of 32 bits");
    CHECK(jsonComplaint(withBody(R"("shapes": [{"circle": {}, "material": {"frictionMix": "largest"}}])")) ==
          "f.json:2: bodies[0].shapes[0].material.frictionMix: \"largest\" is not average, geometricMean, minimum, "
          "product or maximum");
}

TEST_CASE("an impossible value is refused on its line", "[compare][scene][errors]") {
    CHECK(jsonComplaint(withBody("\"shapes\": [\n{\"circle\": {\n\"radius\": -1}}]")) ==
          "f.json:4: bodies[0].shapes[0].circle.radius: -1 is not positive");
    CHECK(jsonComplaint(withBody("\"shapes\": [\n{\"box\": {\n\"halfSize\": [0, 1]}}]")) ==
          "f.json:4: bodies[0].shapes[0].box.halfSize: (0, 1) is not positive");
    CHECK(jsonComplaint(withBody("\"shapes\": [\n{\"capsule\": {\n\"radius\": 0}}]")) ==
          "f.json:4: bodies[0].shapes[0].capsule.radius: 0 is not positive");
    CHECK(jsonComplaint("{\"name\": \"a b\"}") ==
          "f.json:1: name: \"a b\" is not a name of small letters, digits and underscores");
    CHECK(jsonComplaint("{\"name\": \"a\",\n\"dt\": 0}") == "f.json:2: dt: 0 is not positive");
    CHECK(jsonComplaint("{\"name\": \"a\"}") == "f.json:1: bodies: there is none, wanted at least one");
    // A message is one line, whatever the file holds.
    CHECK(jsonComplaint("{\"name\": \"a\\nb\"}") ==
          "f.json:1: name: \"a b\" is not a name of small letters, digits and underscores");
}

TEST_CASE("a scene that is not valid is not written", "[compare][scene][errors]") {
    CHECK(messageOf([] {
              toJson({.name = "a", .bodies = {{"b", {.angle = 1.0 / 0.0}}}});
          }) == "bodies[0].angle: inf is not finite");
}

TEST_CASE("a scene is read from a file, and a file that cannot be read is refused by its name",
          "[compare][scene][errors]") {
    const std::filesystem::path folder = std::filesystem::temp_directory_path();
    const std::filesystem::path path = folder / "plumb_json_test.json";
    std::ofstream(path) << toJson(findScene("free_fall").value());
    CHECK(readScene(path).name == "free_fall");
    std::ofstream(path) << "{\n\"nam\": 1}";
    CHECK(messageOf([&] {
              readScene(path);
          }).starts_with(path.string() + ":2: nam: unknown field, the nearest known one is name; "));
    std::filesystem::remove(path);
    CHECK(messageOf([&] { readScene(path); }) == path.string() + ": cannot be read, wanted a scene's JSON file");
    CHECK(messageOf([&] { readScene(folder); }) == folder.string() + ": is a folder, wanted a scene's JSON file");
}

}  // namespace plumb::compare
