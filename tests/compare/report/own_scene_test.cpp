// SPDX-License-Identifier: MIT
#include <compare/report/report.h>

#include "browser.h"
#include "catch.h"

namespace plumb::compare {
namespace {

/// Without checks and closed form, as a scene of one's own often is. One engine is 1.2 m from Plumb, the other 300 mm.
SceneResult ownScene(const Vec2& gravity) {
    Scene scene = oneDisc();
    scene.name = "own";
    scene.gravity = gravity;
    scene.closedForm.reset();
    const auto pushed = [](const std::string& name, double x) {
        return scripted(name, {[x](double t) {
                            BodyState state = at(x, t);
                            state.velocity = {0, 1 + t};
                            return std::vector<BodyState>{state};
                        }});
    };
    return runScene(scene, {}, {pushed("plumb", 0), pushed("one", 1.2), pushed("two", 0.3)});
}

Opened openedReport(const std::vector<SceneResult>& scenes, const std::string& state) {
    const BrowserFolder folder;
    writeReport(scenes, folder.path);
    return open(folder, "index.html", state);
}

}  // namespace

TEST_CASE("a scene without closed form and checks leads with how far the engines are from Plumb",
          "[compare][report][build]") {
    if (noBrowser()) return;
    const Opened overview = openedReport({ownScene({0, -10})}, "");
    CHECK(overview.messages == "");
    CHECK_THAT(overview.page, test::containsText("one: 1.20&nbsp;m; two: 300&nbsp;mm from Plumb</p>"));
    CHECK_THAT(overview.page, test::containsText("<b>1.20&nbsp;m</b></span>from Plumb at most: one in “Own”"));
    CHECK_THAT(overview.page, test::containsText(">1 scene, not judged<"));
    CHECK_THAT(overview.page, !test::containsText("scenes hold<"));
    const Opened own = openedReport({ownScene({0, -10})}, "scene=own");
    CHECK_THAT(own.page, test::containsText("<span>one: 1.20&nbsp;m; two: 300&nbsp;mm from Plumb</span>"));
}

TEST_CASE("beside scenes that are judged an own one keeps its distances, and the sum counts those that hold",
          "[compare][report][build]") {
    if (noBrowser()) return;
    std::vector<SceneResult> scenes = results();
    scenes.push_back(ownScene({0, -10}));
    const Opened overview = openedReport(scenes, "");
    CHECK_THAT(overview.page, test::containsText("300&nbsp;mm from Plumb</p>"));
    CHECK_THAT(overview.page, test::containsText("scenes hold, 1 not judged"));
}

TEST_CASE("the drift of momentum is listed where nothing acts from outside, and not under gravity",
          "[compare][report][build]") {
    if (noBrowser()) return;
    const std::string falling = openedReport({ownScene({0, -10})}, "scene=own").page;
    CHECK_THAT(falling, test::containsText("<code>energy_drift</code>"));
    CHECK_THAT(falling, !test::containsText("<code>momentum_drift</code>"));
    CHECK_THAT(falling, !test::containsText("<code>angular_momentum_drift</code>"));
    CHECK_THAT(openedReport({ownScene({0, 0})}, "scene=own").page, test::containsText("<code>momentum_drift</code>"));
}

TEST_CASE("a gravity of a third is shown with four digits", "[compare][report][build]") {
    if (noBrowser()) return;
    CHECK_THAT(openedReport({ownScene({9.81, -1.0 / 3})}, "scene=own").page,
               test::containsText("(9.81, −0.3333)&nbsp;m/s²"));
}

TEST_CASE("a drift of a million, and an energy of 12,345,678 J, are shown with at most four digits",
          "[compare][report][build]") {
    if (noBrowser()) return;
    const BrowserFolder folder;
    const Opened opened = openWith(
        folder, {"page/words.js", "page/format.js"},
        "<p id='said'></p><script>document.getElementById('said').textContent = "
        "[quantity(1234567, ''), quantity(1.41, ''), rulerText(12345678, 'J'), rulerText(8667.4, 'J')].join('; ')"
        "</script>");
    CHECK_THAT(opened.page, test::containsText("1.23×10⁶; 141&nbsp;%; 1.235×10⁷&nbsp;J; 8667&nbsp;J</p>"));
}

}  // namespace plumb::compare
