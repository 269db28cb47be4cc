// SPDX-License-Identifier: MIT
#include <compare/command/command.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include <compare/engine/engine.h>
#include <compare/engine/plumb_world.h>
#include <compare/lab/builtin.h>
#include <compare/scene/builtin.h>
#include <compare/scene/json.h>
#include <plumb/record/state_hash.h>

#include "catch.h"
#include "compare/command/called.h"

namespace plumb::compare {
namespace {

namespace fs = std::filesystem;

void write(const std::string& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

/// Status 2, nothing on standard output, one line on standard error that says this.
void checkRefused(const std::vector<std::string>& args, const std::string& saying) {
    const Called called = call(args);
    INFO(called.err);
    CHECK(called.status == 2);
    CHECK(called.err.starts_with("plumb-compare: "));
    CHECK(std::count(called.err.begin(), called.err.end(), '\n') == 1);
    CHECK(called.err.find(saying) != std::string::npos);
}

}  // namespace

TEST_CASE("list tells name, question, engines and checks of free_fall", "[compare][command]") {
    const Called called = call({"list"});
    CHECK(called.status == 0);
    CHECK(called.err.empty());
    const std::size_t start = called.out.find("free_fall\n");
    REQUIRE(start != std::string::npos);
    const std::string entry = called.out.substr(start, called.out.find("\nprojectile\n") - start);
    CHECK(entry.find("?") != std::string::npos);
    CHECK(entry.find("engines plumb, box2d-2.4") != std::string::npos);
    CHECK(entry.find("closed-form") != std::string::npos);
    CHECK(entry.find("exact: plumb within 1e-09 m") != std::string::npos);
}

TEST_CASE("the comparison's page names every lab", "[compare][command]") {
    const std::string page = textOf(PLUMB_SOURCE_DIR "/compare/README.md");
    for (const Lab& lab : builtinLabs()) {
        CAPTURE(lab.name);
        CHECK(page.find("`" + lab.name + "`") != std::string::npos);
    }
}

TEST_CASE("check's JSON has a hash of each scene's last state in Plumb, the one its world has after as many steps",
          "[compare][command]") {
    const Folder folder("plumb_command_hash_test");
    for (const std::string name : {"projectile_damped", "spring_undamped"}) {
        REQUIRE(call({"check", name, "--json", folder / "out.json"}).status == 0);
        const nlohmann::json engines = nlohmann::json::parse(textOf(folder / "out.json"))["scenes"][0]["engines"];

        const Scene scene = *findScene(name);
        PlumbWorld made = plumbWorld(scene);
        for (int step = 0; step < stepCount(scene); ++step) made.world.step(scene.dt);
        CHECK(engines["plumb"]["hash"] == fmt::format("{:016x}", stateHash(made.world)));
        made.world.step(scene.dt);
        CHECK(engines["plumb"]["hash"] != fmt::format("{:016x}", stateHash(made.world)));
        CHECK_FALSE(engines["box2d-2.4"].contains("hash"));
    }
}

TEST_CASE("list tells of the labs after the scenes, in the order in which they run", "[compare][command]") {
    const std::string out = call({"list"}).out;
    std::size_t at = out.find("\n" + builtinScenes().back().name + "\n");
    for (const Lab& lab : builtinLabs()) {
        INFO(lab.name);
        const std::size_t next = out.find("\n" + lab.name + "\n    " + lab.question);
        REQUIRE(next != std::string::npos);
        CHECK(next > at);
        at = next;
    }
}

TEST_CASE("check takes a lab by its name, beside scenes, and writes its verdicts, curves and page",
          "[compare][command]") {
    const Folder folder("plumb_command_test");
    const Called called = call({"check", "integrators", "free_fall", "--json", folder / "out.json", "--csv",
                                folder / "csv", "--report", folder / "report"});
    INFO(called.out << called.err);
    CHECK(called.status == 0);
    CHECK(called.out.find("PASS  free_fall") < called.out.find("PASS  integrators"));
    CHECK(called.out.find("1 lab holds, 0 fail.") != std::string::npos);
    const nlohmann::json json = nlohmann::json::parse(textOf(folder / "out.json"));
    CHECK(json["pass"] == true);
    CHECK(json["scenes"].size() == 1);
    REQUIRE(json["labs"].size() == 1);
    CHECK(json["labs"][0]["name"] == "integrators");
    CHECK(json["labs"][0]["pass"] == true);
    REQUIRE(json["labs"][0]["checks"].size() > 1);
    for (const nlohmann::json& check : json["labs"][0]["checks"]) {
        CHECK(check.size() == 4);
        for (const char* field : {"check", "value", "limit", "pass"}) CHECK(check.contains(field));
    }
    CHECK(textOf(folder / "csv/integrators.csv").starts_with("graph,curve,x,y\n"));
    CHECK(textOf(folder / "report/index.html").find("\"name\":\"integrators\"") != std::string::npos);
}

TEST_CASE("a lab alone is checked without a table of scenes", "[compare][command]") {
    const Called called = call({"check", "integrators"});
    CHECK(called.status == 0);
    CHECK(called.out.find("closed form\n") == std::string::npos);
    CHECK(called.out.find("scene") == std::string::npos);
}

TEST_CASE("export prints a scene that reads back and runs as the built-in one", "[compare][command]") {
    const Called exported = call({"export", "free_fall"});
    CHECK(exported.status == 0);
    CHECK(fromJson(exported.out, "exported").name == "free_fall");
    const Folder folder("plumb_command_test");
    write(folder / "mine.json", exported.out);
    const Called checked = call({"check", folder / "mine.json", "--engines", "plumb,closed-form"});
    INFO(checked.out << checked.err);
    CHECK(checked.status == 0);
    CHECK(checked.out.find("PASS  free_fall") != std::string::npos);
}

TEST_CASE("export and check run a scene with fields that are set on the command line", "[compare][command]") {
    const Called exported = call({"export", "free_fall", "--set", "dt=1/240", "--set", "duration=1"});
    CHECK(exported.status == 0);
    CHECK(fromJson(exported.out, "exported").dt == 1.0 / 240);
    CHECK(fromJson(exported.out, "exported").duration == 1);
    const Folder folder("plumb_command_test");
    const Called checked = call({"check", "free_fall", "--set", "gravity=0,-9.8", "--json", folder / "out.json"});
    CHECK(checked.out.find("      changed: gravity = 0,-9.8\n") != std::string::npos);
    CHECK(checked.status == 0);  // its closed form falls at 9.8, too
    CHECK(checked.out.find("It falls by 19.6 m in 2 s") != std::string::npos);
}

TEST_CASE("export --all shows the fields that have their defaults too", "[compare][command]") {
    const Called few = call({"export", "free_fall"}), all = call({"export", "free_fall", "--all"});
    CHECK(few.out.find("\"linearDamping\"") == std::string::npos);
    CHECK(all.out.find("\"linearDamping\": 0") != std::string::npos);
    CHECK(toJson(fromJson(all.out, "all")) + "\n" == few.out);
}

TEST_CASE("schema prints a JSON Schema, and with --page a page", "[compare][command]") {
    const nlohmann::json schema = nlohmann::json::parse(call({"schema"}).out);
    CHECK(schema["$schema"] == "https://json-schema.org/draft/2020-12/schema");
    CHECK(call({"schema", "--page"}).out.starts_with("# What may stand in a scene's file\n"));
}

TEST_CASE("check writes JSON of schema 1 with metrics of every engine and the verdicts", "[compare][command]") {
    const Folder folder("plumb_command_test");
    const Called called = call({"check", "free_fall", "--steps", "30", "--dt", "0.05", "--json", folder / "out.json"});
    CHECK(called.status == 0);
    const nlohmann::json json = nlohmann::json::parse(textOf(folder / "out.json"));
    CHECK(json["schema"] == 1);
    CHECK(json["pass"] == true);
    REQUIRE(json["scenes"].size() == 1);
    const nlohmann::json& scene = json["scenes"][0];
    CHECK(scene["name"] == "free_fall");
    CHECK(scene["dt"] == 0.05);
    CHECK(call({"check", "free_fall", "--dt", "1/240", "--engines", "plumb"}).out.find("changed: dt = 0.00416667\n") !=
          std::string::npos);
    CHECK(scene["steps"] == 30);
    CHECK(scene["changed"] == nlohmann::json({"dt = 0.05", "steps = 30"}));
    CHECK(scene["pass"] == true);
    CHECK(scene["engines"].size() == engines().size());
    CHECK(scene["engines"]["plumb"]["metrics"]["error_max"] <= 1e-9);
    CHECK(scene["engines"]["plumb"]["metrics"]["joint_error_max"].is_null());
    CHECK(scene["engines"]["plumb"]["metrics"]["divergence_max"].is_null());
    // semi-implicit Euler falls g dt t / 2 too far
    CHECK(scene["engines"]["box2d-2.4"]["metrics"]["error_max"] > 0.3);
    REQUIRE(scene["checks"].size() >= 2);
    for (const char* field : {"check", "engine", "metric", "value", "limit", "pass"})
        CHECK(scene["checks"][0].contains(field));
}

TEST_CASE("an engine that cannot build a scene says so in the JSON, with null metrics", "[compare][command]") {
    const Folder folder("plumb_command_test");
    nlohmann::json scene = nlohmann::json::parse(call({"export", "free_fall"}).out);
    scene["bodies"][0]["shapes"][0]["filter"]["category"] = 1u << 16;
    write(folder / "scene.json", scene.dump());
    const Called called = call({"check", folder / "scene.json", "--steps", "2", "--json", folder / "out.json"});
    INFO(called.err);
    const nlohmann::json json = nlohmann::json::parse(textOf(folder / "out.json"));
    const nlohmann::json& engine = json["scenes"][0]["engines"]["box2d-2.4"];
    CHECK(engine["unsupported"].get<std::string>().find("16 bits") != std::string::npos);
    CHECK(engine["metrics"]["error_max"].is_null());
}

TEST_CASE("a scene whose check fails gives status 1 and says which check, by how much", "[compare][command]") {
    const Folder folder("plumb_command_test");
    nlohmann::json scene = nlohmann::json::parse(call({"export", "free_fall"}).out);
    scene["gravity"] = {0, -9.8};
    const nlohmann::json flight{{"position", {0, 20}}, {"acceleration", {0, -9.81}}};
    scene["closedForm"]["bodies"] = {{{"piecewise", {{"body", "ball"}, {"flights", {flight}}}}}};
    write(folder / "moon.json", scene.dump());
    const Called called = call({"check", folder / "moon.json", "--json", folder / "out.json"});
    CHECK(called.status == 1);
    CHECK(called.out.find("FAIL  free_fall") != std::string::npos);
    CHECK(called.out.find("exact: plumb error_max is 0.02 m, over 1e-09 m") != std::string::npos);
    CHECK(nlohmann::json::parse(textOf(folder / "out.json"))["pass"] == false);
}

TEST_CASE("a scene without checks is not judged: null, grey, exit status 0", "[compare][command]") {
    const Folder folder("plumb_command_test");
    nlohmann::json scene = nlohmann::json::parse(call({"export", "free_fall"}).out);
    scene["checks"] = nlohmann::json::array();
    write(folder / "unchecked.json", scene.dump());
    const std::vector<std::string> alone{"check",  folder / "unchecked.json", "--steps", "2",
                                         "--json", folder / "out.json"};
    std::ostringstream out, err;
    CHECK(runCommand(alone, out, err, true) == 0);
    CHECK(out.str().find("\x1b[90m----\x1b[0m  free_fall") != std::string::npos);
    CHECK(out.str().find("\x1b[90mthis scene has no checks\x1b[0m\n") != std::string::npos);
    const nlohmann::json json = nlohmann::json::parse(textOf(folder / "out.json"));
    CHECK(json["scenes"][0]["pass"].is_null());
    CHECK(json["pass"].is_null());

    const Called beside = call({"check", folder / "unchecked.json", "projectile", "--json", folder / "out.json"});
    CHECK(beside.status == 0);
    CHECK(beside.out.find("1 scene holds, 0 fail, 1 not judged.\n") != std::string::npos);
    const nlohmann::json both = nlohmann::json::parse(textOf(folder / "out.json"));
    CHECK(both["scenes"][0]["pass"].is_null());
    CHECK(both["scenes"][1]["pass"] == true);
    CHECK(both["pass"] == true);
}

TEST_CASE("what a probe expects of a scene as it was is not judged after something was set", "[compare][command]") {
    const Folder folder("plumb_command_test");
    const Called called = call({"check", "block_slides", "--set", "gravity=0,-5", "--json", folder / "set.json"});
    INFO(called.out);
    CHECK(called.status == 0);
    CHECK(called.out.find("not judged, because they expect what holds for the scene as it was: probe.normal\n") !=
          std::string::npos);
    const nlohmann::json json = nlohmann::json::parse(textOf(folder / "set.json"));
    CHECK(json["scenes"][0]["unjudged"] == nlohmann::json::array({"probe.normal"}));
    CHECK(call({"check", "block_slides"}).out.find("3 of 3") != std::string::npos);
    // The closed form says how far a disc has turned, so this follows.
    CHECK(call({"check", "disc_rolls", "--set", "gravity=0,-5"}).out.find("not judged") == std::string::npos);
}

TEST_CASE("a closed form that cannot be worked out is told with its reason, also without an exact check",
          "[compare][command]") {
    const Folder folder("plumb_command_test");
    nlohmann::json scene = nlohmann::json::parse(call({"export", "tip_below"}).out);
    scene["checks"] = nlohmann::json::array();
    write(folder / "tips.json", scene.dump());
    CHECK(call({"check", folder / "tips.json"}).out.find("no closed form: ") == std::string::npos);
    const Called tips = call({"check", folder / "tips.json", "--set", "bodies.incline.angle=-0.6"});
    INFO(tips.out << tips.err);
    CHECK(tips.out.find("      no closed form: closedForm.bodies.block: ") != std::string::npos);
}

TEST_CASE("engines whose results no check looks at are shown but not judged, with status 0", "[compare][command]") {
    const Called called = call({"check", "free_fall", "--engines", "box2d-2.4", "--steps", "5"});
    CHECK(called.status == 0);
    CHECK(called.out.find("----  free_fall") != std::string::npos);
    CHECK(called.out.find("no check binds these engines\n") != std::string::npos);
    CHECK(called.out.find("0 scenes hold, 0 fail, 1 not judged.") != std::string::npos);
}

TEST_CASE("check writes a CSV a scene and the report", "[compare][command]") {
    const Folder folder("plumb_command_test");
    const Called called = call(
        {"check", "free_fall", "projectile", "--steps", "4", "--csv", folder / "csv", "--report", folder / "report"});
    INFO(called.err);
    CHECK(called.status == 0);
    const std::string csv = textOf(folder / "csv/projectile.plumb.csv");
    CHECK(std::count(csv.begin(), csv.end(), '\n') == 6);
    CHECK(fs::exists(folder / "csv/free_fall.plumb.csv"));
    CHECK(textOf(folder / "report/index.html").find("<html") != std::string::npos);
    CHECK(called.out.find("index.html") != std::string::npos);
}

TEST_CASE("help tells the commands and ends with status 0", "[compare][command]") {
    const Called called = call({"--help"});
    CHECK(called.status == 0);
    for (const char* word : {"list", "check", "bench", "export"}) CHECK(called.out.find(word) != std::string::npos);
    CHECK(call({"check", "--help"}).out.find("--engines") != std::string::npos);
}

TEST_CASE("bad usage gives status 2 and one line that says what and where", "[compare][command]") {
    checkRefused({"check", "fre_fall"}, "there is no scene \"fre_fall\": the nearest is free_fall");
    checkRefused({"export", "nothing_like_it"}, "there is no scene \"nothing_like_it\"");
    checkRefused({"export"}, "SCENE");
    checkRefused({"free_fall"}, "free_fall");
    checkRefused({"chek", "free_fall"},
                 "\"chek\" is not a command, the nearest is check; known are list, check, bench, export, schema");
    checkRefused({"bench", "smsh"}, "there is no scene \"smsh\": the nearest is smash; known are six, large_pyramid,");
    checkRefused({"check", "free_fall", "--set", "dt"}, "--set: \"dt\" is not PATH=VALUE");
    checkRefused({"check", "free_fall", "--set", "bodies.bal.angle=1"}, "--set bodies.bal.angle=1: bodies.bal: ");
    checkRefused({"check", "frame_rate", "--set", "dt=1"}, "--set: frame_rate is a lab");
    checkRefused({"check", "--colour"}, "--colour");
    checkRefused({"check", "free_fall", "--engines", "bullet"},
                 "--engines: \"bullet\" is not an engine of this build, "
                 "which has plumb, box2d-2.4");
    checkRefused({"check", "free_fall", "--engines", "plumb,"}, "--engines: \"\"");
    checkRefused({"check", "free_fall", "--engines"}, "--engines");
    for (const std::string steps : {"0", "-3", "1.5", "ten", ""})
        checkRefused({"check", "free_fall", "--steps=" + steps}, "--steps");
    for (const std::string dt : {"0", "-0.1", "nan", "inf", "1/0", "-1/60", "fast", ""})
        checkRefused({"check", "free_fall", "--dt=" + dt}, "--dt");
    checkRefused({"check", "free_fall", "--dt", "100"}, "scene free_fall: dt: 100 is longer than the duration");
    checkRefused({"check", "free_fall", "free_fall"}, "both called \"free_fall\"");
    checkRefused({"check", "frame_rate", "frame_rate"}, "both called \"frame_rate\"");
    checkRefused({"check", "frame_rat"}, "the nearest is frame_rate");
    checkRefused({"check", "free_fall", "frame_rate", "--steps", "5"}, "--steps: frame_rate is a lab");
    checkRefused({"check", "frame_rate", "--dt", "0.1"}, "--dt: frame_rate is a lab");
    checkRefused({"export", "frame_rate"}, "frame_rate is a lab, not a scene");
    checkRefused({"bench", "frame_rate"}, "frame_rate is a lab, not a scene");
}

TEST_CASE("bad files give status 2 and one line with the file and the line", "[compare][command]") {
    const Folder folder("plumb_command_test");
    checkRefused({"check", folder / "missing.json"}, "missing.json");
    write(folder / "broken.json", "{\n  \"name\": \"x\",\n  oops\n}\n");
    checkRefused({"check", folder / "broken.json"}, "broken.json:3");
    std::string text = call({"export", "free_fall"}).out;
    const std::size_t brace = text.find('{');
    write(folder / "unknown.json", text.insert(brace + 1, "\n\"colour\": 3,"));
    checkRefused({"check", folder / "unknown.json"}, "colour");
    checkRefused({"check", "free_fall", "--json", folder / "no/such/folder/out.json"}, "--json: cannot write");
    write(folder / "kept.json", "earlier results");
    checkRefused({"check", "free_fall", "--set", "plumb:solver.subSteps=0", "--json", folder / "kept.json"},
                 "solver.subSteps");
    CHECK(textOf(folder / "kept.json") == "earlier results");
    write(folder / "file", "");
    checkRefused({"check", "free_fall", "--csv", folder / "file/csv"}, "--csv: cannot make the folder");
    checkRefused({"check", "free_fall", "--report", folder / "file"}, "--report: cannot make the folder");
}

}  // namespace plumb::compare
