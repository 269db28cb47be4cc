// SPDX-License-Identifier: MIT
#include <compare/report/report.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "catch.h"
#include "compare/lab/example_lab.h"
#include "compare/scripted.h"

namespace plumb::compare {
namespace {

namespace fs = std::filesystem;

/// A folder of its own that goes when the test does.
struct CsvFolder {
    fs::path path = fs::temp_directory_path() / "plumb_csv_test";
    CsvFolder() { fs::remove_all(path); }
    ~CsvFolder() { fs::remove_all(path); }
};

std::vector<std::string> linesOf(const fs::path& path) {
    std::ifstream file(path);
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);) lines.push_back(line);
    return lines;
}

SceneResult twoSteps() {
    Scene scene = oneDisc();
    scene.gravity = {0, 0};
    scene.dt = 0.25;
    scene.duration = 0.5;
    const Engine closedForm =
        scripted("closed-form", {[](double t) { return std::vector<BodyState>{t > 0.3 ? at(nan, nan) : at(t, 0)}; }});
    const Engine plumb = scripted("plumb", {[](double t) { return std::vector<BodyState>{at(t, 0.125)}; }});
    return runScene(scene, {}, {plumb, unsupporting("box2d-3"), closedForm});
}

}  // namespace

TEST_CASE("an engine's CSV has a line a tick, units in its head, and nothing where nothing is known",
          "[compare][report]") {
    const CsvFolder folder;
    writeCsv({twoSteps()}, folder.path / "deep");
    const std::vector<std::string> lines = linesOf(folder.path / "deep" / "one_disc.plumb.csv");
    REQUIRE(lines.size() == 4);
    CHECK(
        lines[0] ==
        "t [s],disc.x [m],disc.y [m],disc.angle [rad],disc.vx [m/s],disc.vy [m/s],disc.spin [rad/s],"
        "disc.to_truth [m],energy.kinetic [J],energy.potential [J],energy.springs [J],energy.fields [J],to_truth [m]");
    CHECK(lines[1] == "0,0,0.125,0,0,0,0,0.125,0,0,0,0,0.125");
    CHECK(lines[2] == "0.25,0.25,0.125,0,0,0,0,0.125,0,0,0,0,0.125");
    CHECK(lines[3] == "0.5,0.5,0.125,0,0,0,0,,0,0,0,0,");
    CHECK_FALSE(fs::exists(folder.path / "deep" / "one_disc.box2d-3.csv"));
}

TEST_CASE("a body's name with a comma and quotes stays one column", "[compare][report]") {
    const CsvFolder folder;
    SceneResult result = twoSteps();
    result.scene.bodies[0].name = "a, \"b\"";
    writeCsv({result}, folder.path);
    CHECK(linesOf(folder.path / "one_disc.plumb.csv").at(0).starts_with("t [s],\"a, \"\"b\"\".x [m]\","));
}

TEST_CASE("a lab's CSV has a line a point, under its graph and its curve", "[compare][report]") {
    const CsvFolder folder;
    writeLabCsv({exampleResult(2)}, folder.path / "deep");
    const std::vector<std::string> lines = linesOf(folder.path / "deep" / "example_lab.csv");
    REQUIRE(lines.size() == 7);
    CHECK(lines[0] == "graph,curve,x,y");
    CHECK(lines[1] == "Even axes,\"twice, \"\"doubled\"\"\",1,2");
    CHECK(lines[6] == "Logarithmic axes,\"twice, \"\"doubled\"\"\",4,8");
}

TEST_CASE("a CSV that cannot be written is said with its path", "[compare][report]") {
    const CsvFolder folder;
    std::ofstream(folder.path) << "a file where the folder should be";
    CHECK_THROWS_WITH(writeCsv({twoSteps()}, folder.path),
                      "csv: cannot write " + (folder.path / "one_disc.plumb.csv").string());
    CHECK_THROWS_WITH(writeLabCsv({exampleResult(2)}, folder.path),
                      "csv: cannot write " + (folder.path / "example_lab.csv").string());
}

}  // namespace plumb::compare
