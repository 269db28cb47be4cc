// SPDX-License-Identifier: MIT
#include <compare/report/report.h>

#include <fstream>
#include <regex>

#include "browser.h"
#include "catch.h"
#include "compare/lab/example_lab.h"

namespace plumb::compare {
namespace {

/// Draws stairs with the report's own scripts, and says of each row how many of the strokes that hatch it end below the
/// stairs. The middle of the view is at (3.5, 5): it sees one riser from its right and one from its left.
constexpr const char* stairsPage = R"(<p id="said"></p><script>
LOOKS.set("box2d-3", {oneSidedChains: true});
let drawn = [];
let ends = [];
const context = {
    beginPath: () => { drawn = []; },
    moveTo: () => {},
    lineTo: (x, y) => { drawn.push([x / 100, 10 - y / 100]); },
    stroke() { if (this.strokeStyle === "hatch") ends.push(...drawn); },
    setLineDash: () => {},
};
const camera = {x: (x) => 100 * x, y: (y) => 1000 - 100 * y, width: 1000, height: 1000};
const down = [1, 3, 3, 3, 3, 2, 4, 2, 4, 1, 6, 1];
const up = [6, 1, 4, 1, 4, 2, 3, 2, 3, 3, 1, 3];
const segments = [0, 2, 4, 6, 8].map((i) => ({segment: down.slice(i, i + 4)}));
const floorAt = (x) => (x > 4 ? 1 : x > 3 ? 2 : 3);
function say(what, shapes, engines) {
    ends = [];
    const scene = {bodies: [{type: "static", start: [0, 0, 0], shapes}], running: engines.map((name) => ({name}))};
    drawStill(context, camera, {ink: "ink", hatch: "hatch"}, scene, {left: 0, right: 7, bottom: 0, top: 10});
    const under = ends.filter(([x, y]) => y < floorAt(x)).length;
    document.getElementById("said").append(`${what}: ${under} of ${ends.length} below; `);
}
say("to the left", [{chain: up}], ["plumb", "box2d-3"]);
say("to the right", [{chain: down}], ["plumb", "box2d-3"]);
say("to the right in Plumb alone", [{chain: down}], ["plumb"]);
say("of segments", segments, ["plumb", "box2d-3"]);
const pieces = Array.from({length: 101}, (_, i) => [6 - i / 20, 1]).flat();
say("of 100 pieces", [{chain: pieces}], ["plumb", "box2d-3"]);
</script>)";

double clockOf(const std::string& page) {
    std::smatch found;
    REQUIRE(std::regex_search(page, found, std::regex("<output id=\"clock\"[^>]*>([0-9.]+)&nbsp;s</output>")));
    return std::stod(found[1]);
}

}  // namespace

TEST_CASE("opened from disk at 0.2 s and playing, the report's clock moves on and nothing complains",
          "[compare][report][build]") {
    if (noBrowser()) return;
    const BrowserFolder folder;
    writeReport(results(), folder.path);
    const Opened opened = open(folder, "index.html", "scene=one_disc&t=0.2&play=1&speed=0.125");
    CHECK(clockOf(opened.page) > 0.2);
    CHECK(opened.messages == "");
    // Each of the four charts is drawn by the library.
    CHECK_THAT(opened.page, test::containsText("dygraph-axis-label"));
}

TEST_CASE("a link to a moment shows that moment, with the numbers as a person reads them", "[compare][report][build]") {
    if (noBrowser()) return;
    const BrowserFolder folder;
    writeReport(results(), folder.path);
    const Opened opened = open(folder, "index.html", "scene=one_disc&t=0.5");
    CHECK(opened.messages == "");
    CHECK(clockOf(opened.page) == 0.5);
    CHECK_THAT(opened.page, test::containsText("step 5 of 10"));
    CHECK_THAT(opened.page, test::containsText("1.20&nbsp;mm"));
    CHECK_THAT(opened.page, test::containsText("3.00×10⁻¹³&nbsp;m"));
    CHECK_THAT(opened.page, test::containsText("does not run this scene: it has no such thing"));
    CHECK_THAT(opened.page, test::containsText("Does &lt;/script&gt; end the page?"));
}

TEST_CASE("opened without a scene the report lists the verdicts and says what fails", "[compare][report][build]") {
    if (noBrowser()) return;
    const BrowserFolder folder;
    writeReport(results(), folder.path);
    const Opened opened = open(folder, "index.html", "");
    CHECK(opened.messages == "");
    CHECK_THAT(opened.page, test::containsText("✗ fails"));
    CHECK_THAT(opened.page,
               test::containsText("Plumb: largest distance to the closed form 1.20&nbsp;mm, not ≤&nbsp;1&nbsp;mm"));
}

TEST_CASE("a scene and a lab without checks are shown in grey as not judged, and counted apart",
          "[compare][report][build]") {
    if (noBrowser()) return;
    const BrowserFolder folder;
    std::vector<SceneResult> scenes = results();
    Scene unchecked = oneDisc();
    unchecked.name = "unchecked";
    scenes.push_back(runScene(unchecked, {}, {standing("plumb", 0)}));
    Lab lab = exampleLab(2);
    lab.checks.clear();
    writeReport(scenes, folder.path, {runLab(lab, {}, {})});
    const Opened opened = open(folder, "index.html", "scene=unchecked");
    CHECK(opened.messages == "");
    CHECK_THAT(opened.page, test::containsText("0 of 2 scenes hold, 1 not judged"));
    CHECK_THAT(opened.page, test::containsText("0 of 1 labs hold, 1 not judged"));
    CHECK_THAT(opened.page, test::containsText("<span class=\"verdict unjudged\">– not judged</span>"
                                               "<span>this scene has no checks</span>"));
    CHECK_THAT(opened.page, !test::containsText("✓ holds"));
    const std::string page = open(folder, "index.html", "lab=example_lab").page;
    CHECK_THAT(page, test::containsText("<span>this lab has no checks</span>"));
}

TEST_CASE("a link to a lab shows what was seen, its graphs drawn, and its checks", "[compare][report][build]") {
    if (noBrowser()) return;
    const BrowserFolder folder;
    writeReport(results(), folder.path, {exampleResult(3)});
    const Opened opened = open(folder, "index.html", "lab=example_lab");
    CHECK(opened.messages == "");
    CHECK_THAT(opened.page, test::containsText("The way grows by 2 m a second."));
    CHECK_THAT(opened.page, test::containsText("slope: 3.00&nbsp;m/s, not ≤&nbsp;2.5&nbsp;m/s"));
    CHECK_THAT(opened.page, test::containsText("Logarithmic axes"));
    CHECK_THAT(opened.page, test::containsText("way [m]"));
    CHECK_THAT(opened.page, test::containsText("dygraph-axis-label"));
    CHECK_THAT(opened.page, test::containsText("0 of 1 labs hold"));
}

TEST_CASE("opened without a scene the report lists the labs, with or without scenes", "[compare][report][build]") {
    if (noBrowser()) return;
    const BrowserFolder folder;
    writeReport({}, folder.path, {exampleResult(2)});
    const Opened opened = open(folder, "index.html", "");
    CHECK(opened.messages == "");
    CHECK_THAT(opened.page, test::containsText("#lab=example_lab"));
    CHECK_THAT(opened.page, test::containsText("1 of 1 labs hold"));
}

// A stroke every 11 pixels, from 8 on: 18 on each of the two treads of 200 pixels, 9 on each of the three other pieces.
TEST_CASE("stairs are hatched on one side all along: the left of a chain where Box2D runs, else away from the middle",
          "[compare][report][build]") {
    if (noBrowser()) return;
    const BrowserFolder folder;
    const Opened opened = openWith(
        folder, {"page/engines.js", "page/data.js", "stage/pose.js", "stage/stage.js", "stage/still.js"}, stairsPage);
    CHECK(opened.messages == "");
    CHECK_THAT(opened.page, test::containsText("to the left: 63 of 63 below"));
    CHECK_THAT(opened.page, test::containsText("to the right: 0 of 63 below"));
    CHECK_THAT(opened.page, test::containsText("to the right in Plumb alone: 63 of 63 below"));
    CHECK_THAT(opened.page, test::containsText("of segments: 63 of 63 below"));
    // Pieces of 5 pixels: every second one gets a stroke.
    CHECK_THAT(opened.page, test::containsText("of 100 pieces: 50 of 50 below"));
}

// What the tests above rest on: a page that may load nothing says so when it tries.
TEST_CASE("a page that logs an error or tries to load something does not pass unseen", "[compare][report][build]") {
    if (noBrowser()) return;
    const BrowserFolder folder;
    std::ofstream(folder.path / "bad.html") << "<meta http-equiv='Content-Security-Policy'"
                                               " content=\"default-src 'none'; script-src 'unsafe-inline'\">"
                                               "<script>console.error('one')</script><script>two()</script>"
                                               "<img src='http://plumb.invalid/three.png'>"
                                               "<script>fetch('http://plumb.invalid/four')</script>";
    const Opened opened = open(folder, "bad.html", "");
    CHECK_THAT(opened.messages, test::containsText("one"));
    CHECK_THAT(opened.messages, test::containsText("two is not defined"));
    CHECK_THAT(opened.messages, test::containsText("three.png"));
    CHECK_THAT(opened.messages, test::containsText("plumb.invalid/four"));
}

}  // namespace plumb::compare
