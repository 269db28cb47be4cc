// SPDX-License-Identifier: MIT
#include <compare/web/live.h>

#include <limits>

#include <compare/engine/engine.h>
#include <compare/scene/bench.h>
#include <compare/scene/builtin.h>

#include "catch.h"

namespace plumb::compare {
namespace {

constexpr double noLimit = std::numeric_limits<double>::infinity();

Live liveOf(const std::string& name) {
    return Live(findScene(name).value());
}

/// Runs to the end, in Plumb alone.
SceneResult resultOf(Live& live) {
    live.start({subjectName()});
    live.advance(live.lastTick(), noLimit);
    return live.resultOfRuns(false);
}

Vec2 placeOf(const Live& live, std::size_t body) {
    return live.seen(0).states.back().at(body).position;
}

}  // namespace

TEST_CASE("a live run ends as the command's does, in all engines of the build", "[compare][web]") {
    for (const char* name : {"projectile", "stack_of_ten", "breaking_bridge", "terrain_disc"}) {
        Live live = liveOf(name);
        live.start();
        while (!live.isOver()) live.advance(live.lastTick(), 1);
        CHECK(live.tick() == live.lastTick());
        const SceneResult mine = live.resultOfRuns(false);
        const SceneResult theirs = runScene(findScene(name).value(), {}, engines());
        REQUIRE(mine.engines.size() == theirs.engines.size());
        for (std::size_t i = 0; i < mine.engines.size(); ++i) {
            const Observation &a = mine.engines[i].observation, &b = theirs.engines[i].observation;
            CHECK(a.engine == b.engine);
            CHECK(a.hash == b.hash);
            CHECK(a.states.size() == b.states.size());
        }
        CHECK(mine.outcomes.size() == theirs.outcomes.size());
        CHECK(mine.verdict == theirs.verdict);
    }
}

TEST_CASE("without time a live run still goes on by one tick, and never beyond the tick that was asked for",
          "[compare][web]") {
    Live live = liveOf("projectile");
    live.start();
    live.advance(100, 0);
    CHECK(live.tick() == 1);
    live.advance(1, noLimit);
    CHECK(live.tick() == 1);
    live.advance(7, noLimit);
    CHECK(live.tick() == 7);
    live.advance(100'000, noLimit);
    CHECK((live.isOver() && live.tick() == live.lastTick()));
}

TEST_CASE("the last value of a field holds, and a refused one changes nothing", "[compare][web]") {
    Live live = liveOf("projectile");
    live.set({"gravity.1", "-5"});
    live.set({"dt", "1/120"});
    live.set({"gravity.1", "-3"});
    CHECK(live.changed() == std::vector<std::string>{"dt = 1/120", "gravity.1 = -3"});
    CHECK_THROWS_AS(live.set({"gravity.1", "down"}), std::invalid_argument);
    CHECK_THROWS_AS(live.set({"bodies.ball.shapes.0.circle.radius", "-1"}), std::invalid_argument);
    CHECK(live.scene().gravity.y() == -3);
    CHECK(live.changed().size() == 2);
    CHECK(resultOf(live).changed == live.changed());
    live.reset();
    CHECK((live.changed().empty() && live.scene().gravity.y() == -9.81));
}

TEST_CASE("a changed scene is kept without the checks that hold for it as it was", "[compare][web]") {
    Live live = liveOf("block_slides");
    CHECK(live.sceneToKeep().checks.size() == live.scene().checks.size());
    live.set({"bodies.incline.angle", "-0.35"});
    live.set({"bodies.block.angle", "-0.35"});
    const Scene kept = live.sceneToKeep();
    CHECK(kept.checks.size() == live.scene().checks.size() - 1);  // probe.normal expects the force at 30 degrees
    CHECK(runScene(kept, {}, engines()).verdict == Verdict::Holds);
    CHECK(runScene(live.scene(), {}, engines()).verdict == Verdict::Fails);
}

TEST_CASE("a hand carries a box up, and when it lets go the box falls: what it did before is kept", "[compare][web]") {
    Live live = liveOf("box_at_rest");
    const std::size_t box = 1;
    live.start({subjectName()});
    live.advance(60, noLimit);
    const BodyState before = live.seen(0).states.at(30).at(box);
    live.hold(30, Hand{box, {0, 0}, {0, 3}});
    CHECK(live.tick() == 30);
    CHECK((live.wasHeld() && live.seen(0).states.at(30).at(box).position == before.position));
    live.advance(90, noLimit);
    CHECK(placeOf(live, box).y() > 2.5);
    live.hold(90, {});
    live.advance(live.lastTick(), noLimit);
    CHECK(placeOf(live, box).y() < 0.51);
    const Vec2 end = placeOf(live, box);
    // A hand that comes at 40 is the one that came at 30, which is kept: the way is the same, computed from the start.
    live.hold(40, Hand{box, {0, 0}, {0, 3}});
    live.hold(90, {});
    live.advance(live.lastTick(), noLimit);
    CHECK((placeOf(live, box) - end).norm() < 1e-3);
    CHECK(placeOf(live, box).y() < 0.51);
    live.start({subjectName()});
    CHECK(!live.wasHeld());
}

TEST_CASE("a hand at a body that is not there is refused", "[compare][web]") {
    Live live = liveOf("box_at_rest");
    live.start();
    CHECK_THROWS_WITH(live.hold(0, Hand{7, {0, 0}, {0, 0}}), "hold: there is no such body");
}

TEST_CASE("every control of a built-in scene sets fields that the scene has", "[compare][web]") {
    int controls = 0;
    for (const Scene& scene : builtinScenes()) {
        for (const SceneControl& control : scene.controls) {
            CAPTURE(scene.name, control.label);
            ++controls;
            const bool isVector = control.as == ShownAs::X || control.as == ShownAs::Y || control.as == ShownAs::Size ||
                                  control.as == ShownAs::Direction || control.as == ShownAs::Hanging;
            for (const std::string& path : control.set)
                CHECK_NOTHROW(withField(scene, path, isVector ? "0.5,0.75" : "0.5"));
        }
    }
    CHECK(controls > 50);
}

}  // namespace plumb::compare
