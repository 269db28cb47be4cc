// SPDX-License-Identifier: MIT
#include <compare/report/report.h>

#include <compare/report/page.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "catch.h"
#include "compare/scripted.h"

namespace plumb::compare {
namespace {

namespace fs = std::filesystem;

/// A folder of its own that goes when the test does.
struct ReportFolder {
    fs::path path = fs::temp_directory_path() / "plumb_report_test";
    ReportFolder() { fs::remove_all(path); }
    ~ReportFolder() { fs::remove_all(path); }
};

std::string textOf(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

std::vector<SceneResult> oneResult() {
    return {runScene(oneDisc(), {}, {standing("plumb", 0)})};
}

}  // namespace

TEST_CASE("the report is one file with the chart library, the page and readable data in it", "[compare][report]") {
    const ReportFolder folder;
    writeReport(oneResult(), folder.path / "deep");
    CHECK(std::distance(fs::directory_iterator(folder.path / "deep"), fs::directory_iterator()) == 1);
    const std::string text = textOf(folder.path / "deep" / "index.html");
    CHECK_THAT(text, test::containsText("dygraphs/blob"));  // its licence line
    CHECK_THAT(text, test::containsText("<output id=\"clock\""));
    CHECK(text.find(pageDataMark) == std::string::npos);

    const std::string opening = "<script type=\"application/json\" id=\"data\">";
    const std::size_t start = text.find(opening) + opening.size();
    const std::string data = text.substr(start, text.find("</script>", start) - start);
    CHECK(nlohmann::json::parse(data).at("scenes").at(0).at("name") == "one_disc");
}

TEST_CASE("the page forbids itself to load anything, and names nothing to load", "[compare][report]") {
    const std::string text(page());
    CHECK_THAT(text, test::containsText("Content-Security-Policy\"\n      content=\"default-src 'none'"));
    for (const char* loading :
         {"src=\"http", "href=\"http", "@import", "url(", "sourceMappingURL", "<link rel=\"stylesheet"})
        CHECK(text.find(loading) == std::string::npos);
}

TEST_CASE("a folder that cannot be made is refused by the file's name", "[compare][report]") {
    const ReportFolder folder;
    std::ofstream(folder.path) << "a file";
    CHECK_THROWS_WITH(writeReport(oneResult(), folder.path),
                      test::containsText("report: cannot write") && test::containsText("index.html"));
}

}  // namespace plumb::compare
