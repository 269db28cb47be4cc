// SPDX-License-Identifier: MIT
#include <compare/report/report.h>

#include <fstream>
#include <sstream>

#include "browser.h"
#include "catch.h"
#include "compare/lab/example_lab.h"

namespace plumb::compare {
namespace {

std::string wholeFile(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

/// A copy of a page that looks at its own texts (layout_check.js) and tells the page around it.
void writeWatched(const fs::path& page, const fs::path& copy) {
    const std::string text = wholeFile(page);
    const std::size_t end = text.rfind("</body>");
    REQUIRE(end != std::string::npos);
    std::ofstream(copy, std::ios::binary)
        << text.substr(0, end) << "<script>" << wholeFile(PLUMB_SOURCE_DIR "/tests/compare/report/layout_check.js")
        << "setTimeout(() => parent.postMessage({...layoutFaults(), seen: isStageSeenPlaying()}, '*'), 1500);</script>"
        << text.substr(end);
}

/// A page that shows the copy in frames of several widths, all in one place, so that each is on the screen.
constexpr const char* framesPage = R"(<p id="said"></p><script>
const states = ["", "#scene=one_disc&t=0.5", "#lab=example_lab"];
const frames = [390, 820, 1440, 1920].flatMap((width) => states.map((state) => {
    const frame = document.createElement("iframe");
    frame.style = `position: absolute; left: 0; top: 0; border: 0; width: ${width}px; height: 900px`;
    frame.src = `watched.html${state}`;
    document.body.append(frame);
    return {frame, name: `${width} ${state || "overview"}`};
}));
addEventListener("message", ({data, source}) => {
    const {name} = frames.find(({frame}) => frame.contentWindow === source);
    const line = document.createElement("p");
    line.textContent = data.texts < 10 ? `${name}: too few texts` : `${name}: ${data.faults.length} faults` +
        `${data.seen ? ", stage in view" : ""}${data.faults.join("; ")}`;
    document.getElementById("said").append(line);
});
</script>)";

}  // namespace

// Of the stage: its controls stay at the screen's lower edge, and on a phone they once played what nobody saw.
TEST_CASE("at 390 to 1,920 pixels no text of the report is cut off or over another, and what plays is on the screen",
          "[compare][report][build]") {
    if (noBrowser()) return;
    const BrowserFolder folder;
    writeReport(results(), folder.path, {exampleResult(3)});
    writeWatched(folder.path / "index.html", folder.path / "watched.html");
    std::ofstream(folder.path / "frames.html") << "<body>" << framesPage << "</body>";
    const Opened opened = open(folder, "frames.html", "");
    CHECK(opened.messages == "");
    for (const std::string width : {"390", "820", "1440", "1920"}) {
        for (const char* state : {" overview", " #lab=example_lab"})
            CHECK_THAT(opened.page, test::containsText(width + state + ": 0 faults"));
        CHECK_THAT(opened.page, test::containsText(width + " #scene=one_disc&amp;t=0.5: 0 faults, stage in view"));
    }
}

// What the test above rests on.
TEST_CASE("a text that is cut off and one that lies over another are found", "[compare][report][build]") {
    if (noBrowser()) return;
    const BrowserFolder folder;
    std::ofstream page(folder.path / "bad.html");
    page << "<body><p style='width: 40px; overflow: hidden; white-space: nowrap'>much too long</p>"
            "<p style='position: absolute; top: 90px'>below</p><p style='position: absolute; top: 95px'>above</p>"
            "<p style='margin-top: 120px'>well</p><p id='said'></p><script>"
         << wholeFile(PLUMB_SOURCE_DIR "/tests/compare/report/layout_check.js")
         << "document.getElementById('said').textContent = layoutFaults().faults.join('; ');</script></body>"
         << std::flush;
    const Opened opened = open(folder, "bad.html", "");
    CHECK(opened.messages == "");
    CHECK_THAT(opened.page, test::containsText("cut off: \"much too long\"; \"below\" over \"above\"</p>"));
}

}  // namespace plumb::compare
