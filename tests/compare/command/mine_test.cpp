// SPDX-License-Identifier: MIT
#include <compare/command/command.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "compare/command/called.h"

namespace plumb::compare {
namespace {

/// The rows of compare/README.md.
constexpr const char* throwOfThePage =
    "t,x,y\n0,0,0\n0.5,7.05,5.88\n1,14.16,9.20\n1.5,21.18,10.21\n2,28.32,8.63\n2.5,35.30,4.72\n";

struct ThrowFile {
    Folder folder{"plumb_command_mine_test"};
    std::string path = folder / "throw.csv";
    explicit ThrowFile(const std::string& csv = throwOfThePage) { std::ofstream(path, std::ios::binary) << csv; }
};

void checkMineRefused(const std::vector<std::string>& args, const std::string& message) {
    const Called called = call(args);
    CHECK(called.status == 2);
    CHECK(called.err == "plumb-compare: " + message + "\n");
}

}  // namespace

TEST_CASE("check --mine shows six places of a throw as one more engine, 59.2 mm from the closed form",
          "[compare][command]") {
    const ThrowFile file;
    const Called called = call({"check", "projectile", "--mine", file.path, "--json", file.folder / "out.json", "--csv",
                                file.folder / "csv", "--report", file.folder / "report"});
    CHECK(called.err.empty());
    CHECK(called.status == 0);
    CHECK(called.out.find("         mine  checks that hold\n") != std::string::npos);
    CHECK(called.out.find("      59.2 mm  3 of 3\n") != std::string::npos);
    CHECK(called.out.find("      mine: It rises to 10.2 m at 1.45 s, and comes – far.\n") != std::string::npos);
    const nlohmann::json json = nlohmann::json::parse(textOf(file.folder / "out.json"));
    const nlohmann::json& mine = json["scenes"][0]["engines"]["mine"];
    CHECK(std::abs(mine["metrics"]["error_max"].get<double>() - 0.0592) < 1e-4);
    CHECK(mine["metrics"]["ms_per_step"].is_null());
    CHECK(textOf(file.folder / "csv/projectile.mine.csv").starts_with("t [s],ball.x [m],ball.y [m]"));
    CHECK(textOf(file.folder / "report/index.html").find("\"label\":\"Mine\"") != std::string::npos);
}

TEST_CASE("check --mine beside the engines asked for shows both", "[compare][command]") {
    const ThrowFile file;
    const Called called = call({"check", "projectile", "--engines", "plumb", "--mine", file.path});
    CHECK(called.status == 0);
    CHECK(called.out.find("scene             plumb         mine  checks that hold\n") != std::string::npos);
}

TEST_CASE("check --mine wants one scene and a table", "[compare][command][errors]") {
    const ThrowFile file;
    checkMineRefused({"check", "--mine", file.path}, "--mine: no scene is named, wanted one");
    checkMineRefused({"check", "projectile", "free_fall", "--mine", file.path},
                     "--mine: projectile free_fall is 2 scenes, wanted one");
    checkMineRefused({"check", "convergence", "--mine", file.path}, "--mine: convergence is a lab, wanted a scene");
    checkMineRefused({"check", "projectile", "--mine", ""}, "--mine: \"\" is not a path");
    const std::string none = file.folder / "none.csv", folder = file.folder.path.string();
    checkMineRefused({"check", "projectile", "--mine", none},
                     none + ": cannot be read, wanted a table with columns t, x and y");
    checkMineRefused({"check", "projectile", "--mine", folder},
                     folder + ": is a folder, wanted a table with columns t, x and y");
}

TEST_CASE("check --mine refuses a fault of the table with its line, and a body that the scene does not have",
          "[compare][command][errors]") {
    const ThrowFile faulty("t,x,y\n0,0,0\n1,abc,0\n");
    checkMineRefused({"check", "projectile", "--mine", faulty.path}, faulty.path + ":3: x: \"abc\" is not a number");
    std::ofstream(faulty.path, std::ios::binary) << "t,x,y,body\n0,0,0,bal\n1,1,1,bal\n";
    checkMineRefused({"check", "projectile", "--mine", faulty.path},
                     "scene projectile: " + faulty.path +
                         ": body: \"bal\" is not the name of a body that moves, the nearest is ball; known are ball");
}

}  // namespace plumb::compare
