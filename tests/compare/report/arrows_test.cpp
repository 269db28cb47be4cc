// SPDX-License-Identifier: MIT
#include "browser.h"
#include "catch.h"

namespace plumb::compare {
namespace {

/// Runs the report's own scripts on written ways of bodies of 2 kg, and says in how many of 9 moments a force is drawn.
/// The way's x is kept in floats, as in an engine that has floats; the steps are of 1/60 s.
constexpr const char* arrowsPage = R"(<p id="said"></p><script>
const times = Array.from({length: 11}, (_, frame) => frame / 60);
function spoken(what, gravity, ...ways) {
    const bodies = ways.map(() => ({type: "dynamic", start: [0, 0, 0], mass: 2}));
    const poses = times.flatMap((t) => ways.flatMap((way) => [Math.fround(way(t)), 0, 0]));
    const engine = {bodies: ways.map((_, i) => i), slots: new Map(ways.map((_, i) => [i, i])), ticks: 11, poses};
    const scene = {bodies, running: [engine], gravity, times, ticks: [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10],
        lengthStep: 2 ** -24};
    const drawn = ways.map((_, body) => times.filter((_, frame) => ARROWS.force.of(scene, engine, frame, body)).length);
    document.getElementById("said").append(`${what}: ${drawn.join(", ")}; `);
}
const earth = [0, -9.81];
spoken("slides on ice", earth, (t) => 4 + 3.1 * t);
spoken("slides without gravity", [0, 0], (t) => 4 + 3.1 * t);
spoken("pushed with half a thousandth of the weight", earth, (t) => 0.0005 * 9.81 * t * t / 2);
spoken("pushed with five thousandths", earth, (t) => 0.005 * 9.81 * t * t / 2);
const bounce = (t) => Math.abs(t - 5 / 60);
spoken("bounces without gravity, beside one that is pushed a little", [0, 0], bounce, (t) => 0.01 * t * t / 2);
spoken("is pushed a little, alone", [0, 0], (t) => 0.01 * t * t / 2);
</script>)";

}  // namespace

// The arrows of discs that slid on ice said 500 µN.
TEST_CASE("a force is drawn from a thousandth of the weight on, or of the run's largest force, rounding never is",
          "[compare][report][build]") {
    if (noBrowser()) return;
    const BrowserFolder folder;
    const Opened opened = openWith(folder,
                                   {"page/engines.js", "page/data.js", "stage/pose.js", "stage/stage.js",
                                    "stage/quantities.js", "stage/arrows.js"},
                                   arrowsPage);
    CHECK(opened.messages == "");
    CHECK_THAT(opened.page, test::containsText("slides on ice: 0;"));
    CHECK_THAT(opened.page, test::containsText("slides without gravity: 0;"));
    CHECK_THAT(opened.page, test::containsText("half a thousandth of the weight: 0;"));
    CHECK_THAT(opened.page, test::containsText("five thousandths: 9;"));
    // The bounce takes 2 m/s within one step: 2 kg 2 m/s 60 / s = 240 N. A push of 0.02 N is less than 0.24 N.
    CHECK_THAT(opened.page, test::containsText("pushed a little: 1, 0;"));
    CHECK_THAT(opened.page, test::containsText("is pushed a little, alone: 9;"));
}

}  // namespace plumb::compare
