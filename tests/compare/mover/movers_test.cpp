// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <string>

#include <compare/metric/geometry.h>
#include <compare/metric/observation.h>
#include <compare/scene/builtin.h>
#include <compare/scene/json.h>
#include "catch.h"
#include "compare/mover/complaint.h"

using namespace plumb;
using namespace plumb::compare;
using plumb::test::containsText;

namespace {

const Engine& engineNamed(const std::string& name) {
    return *std::find_if(engines().begin(), engines().end(), [&](const Engine& e) { return e.name == name; });
}

/// A kinematic disc over a map of tiles, and a mover of it.
std::string withMover(const std::string& mover) {
    return R"({"name": "a", "duration": 1, "bodies": [
{"name": "map", "type": "static", "shapes": [{"tiles": {"rows": ["###", "#.#", "###"]}}]},
{"name": "hero", "type": "kinematic", "position": [1.5, 1.5], "shapes": [{"circle": {"radius": 0.4}}]},
{"name": "ball", "shapes": [{"circle": {}}]}],
"movers": [{"name": "m", "body": "hero", )" +
           mover + "}]}";
}

}  // namespace

TEST_CASE("tiles, movers of all four kinds and a wrap are read from a file, and written as they were",
          "[compare][movers][tiles]") {
    for (const char* mover :
         {R"("path": {"points": [[0, 0], [2, 1], [4, 0]], "spline": true, "easing": "smoothStep", "repeat": "loop",
"closed": true, "delay": 0.5, "speed": 2})",
          R"("slide": {"velocity": [1, -2], "pushStrength": 20, "standIn": "stopped"})",
          R"("grid": {"map": "map", "cell": {"column": 1, "row": 1}, "heading": "left", "turns": ["up", "down"]})",
          R"("platform": {"profile": "1985", "cues": [{"time": 0.5, "move": 1, "run": true, "jump": true}]})"}) {
        const Scene scene = fromJson(withMover(mover), "f.json");
        REQUIRE(scene.movers.size() == 1);
        const std::string once = toJson(scene);
        CHECK(toJson(fromJson(once, "g.json")) == once);
        CHECK(std::get<TileMap>(scene.bodies[0].def.shapes[0].shape).at({0, 2}).form == TileForm::Full);
    }
    const Scene around = fromJson(
        R"({"name": "a", "wrap": {"width": 8}, "bodies": [{"name": "b", "shapes": [{"circle": {}}]}]})", "f.json");
    CHECK(around.wrap.width == 8);
    CHECK_FALSE(around.wrap.height);
    CHECK_THAT(toJson(around), containsText("\"width\": 8"));
}

TEST_CASE("a mover, a map or a wrap that cannot be is refused by its place in the file", "[compare][movers][tiles]") {
    CHECK_THAT(complaint(withMover(R"("path": {"points": [[0, 0]]})")), containsText("movers[0].path.points: 1 make"));
    CHECK_THAT(complaint(withMover(R"("path": {"points": [[0, 0], [1, 0]], "speed": 0})")),
               containsText("movers[0].path.speed: 0"));
    CHECK_THAT(complaint(withMover(R"("grid": {"map": "ball"})")), containsText("movers[0].grid.map: \"ball\""));
    CHECK_THAT(complaint(withMover(R"("grid": {"map": "map", "cell": {"column": 9}})")),
               containsText("movers[0].grid.cell"));
    CHECK_THAT(complaint(withMover(R"("slide": {"pushStrength": -1})")),
               containsText("movers[0].slide.pushStrength: -1"));
    CHECK_THAT(complaint(withMover(R"("platform": {"cues": [{"move": 2}]})")),
               containsText("movers[0].platform.cues[0].move: 2"));
    CHECK_THAT(complaint(withMover(R"("platform": {"cues": [{"time": 1}, {"time": 0.5}]})")),
               containsText("movers[0].platform.cues[1].time: 0.5"));
    std::string free = withMover(R"("slide": {})");
    free.replace(free.find("\"body\": \"hero\""), 14, "\"body\": \"ball\"");
    CHECK_THAT(complaint(free), containsText("movers[0].body: \"ball\" is not kinematic"));
    std::string odd = withMover(R"("slide": {})");
    odd.replace(odd.find("#.#"), 3, "#?#");
    CHECK_THAT(complaint(odd), containsText("rows[1][1]: '?'"));
    CHECK_THAT(
        complaint(R"({"name": "a", "wrap": {"width": 0}, "bodies": [{"name": "b", "shapes": [{"circle": {}}]}]})"),
        containsText("wrap.width: 0"));
}

TEST_CASE("a body that is slowed down twice is caught twice, and one that is sped up is not", "[compare][metric]") {
    Scene scene{.name = "a", .duration = 1, .dt = 0.1, .bodies = {{"b", {.shapes = {circle(1)}}}}};
    scene.closedForm = ClosedForm{.bodies = {PiecewiseMotion{"b",
                                                             {{.velocity = {3, 0}},
                                                              {.start = 0.25, .velocity = {2, 0}},
                                                              {.start = 0.45, .velocity = {2.5, 0}},
                                                              {.start = 0.65, .velocity = {2.495, 0}},
                                                              {.start = 0.85, .velocity = {1, 0}}}}}};
    scene.probes = {{.name = "snags", .quantity = SnagsProbe{.body = "b"}, .unit = "-"}};
    const Observation seen = observe(scene, engineNamed("closed-form"));
    CHECK(seen.probes[2][0] == 0);
    CHECK(seen.probes[3][0] == 1);
    CHECK(seen.probes.back()[0] == 2);
}

TEST_CASE("in Box2D a mover that nothing stands in the way of is where it is in Plumb, to 1e-5 m",
          "[compare][movers]") {
    for (const char* name : {"maze_lap", "platform_ride"}) {
        const Scene scene = findScene(name).value();
        const std::size_t moved = scene.movers.front().body == scene.bodies[0].name ? 0 : 1;
        const Observation plumb = observe(scene, engineNamed("plumb"));
        for (const Engine& engine : engines()) {
            if (engine.role != Role::Peer) continue;
            const Observation other = observe(scene, engine);
            double worst = 0;
            for (std::size_t tick = 0; tick < plumb.states.size(); ++tick)
                worst =
                    std::max(worst, (plumb.states[tick][moved].position - other.states[tick][moved].position).norm());
            INFO(name << " in " << engine.name);
            CHECK(worst < 1e-5);
        }
    }
}

TEST_CASE(
    "in other engines what shall be stopped as a slider slides 20 m along one slab uncaught, and stops at a wall to 16 "
    "mm",
    "[compare][movers]") {
    for (const ShapeDef& shape : {capsule({0, -0.25}, {0, 0.25}, 0.25), box({0.25, 0.5})}) {
        Scene scene{.name = "a", .duration = 2.5};
        scene.bodies = {{"slab", {.type = BodyType::Static, .position = {10, -0.5}, .shapes = {box({15, 0.5})}}},
                        {"wall", {.type = BodyType::Static, .position = {20.5, 1}, .shapes = {box({0.25, 1})}}},
                        {"hero", {.type = BodyType::Kinematic, .position = {0, 0.501}, .shapes = {shape}}}};
        scene.movers = {{"m", "hero", SlidingMotion{{10, -2}, 0, StandIn::Stopped}}};
        scene.probes = {{.name = "snags", .quantity = SnagsProbe{.body = "hero"}, .unit = "-", .until = 1.95}};
        for (const Engine& engine : engines()) {
            if (engine.role == Role::Truth) continue;
            const Observation seen = observe(scene, engine);
            INFO(engine.name);
            CHECK(seen.probes[117][0] == 0);  // after 1.95 s, short of the wall
            // Chipmunk moves bodies before it stops them: it starts a step late.
            const double late = engine.name == "chipmunk" ? 10.0 / 60 : 0;
            CHECK(seen.states[117][2].position.x() == Approx(19.5 - late).margin(0.02));
            // Box2D 2.4 keeps polygons 15 mm apart: two skins of 10 mm, less a slop of 5 mm.
            CHECK((seen.states.back()[2].position - Vec2(20, 0.5)).cwiseAbs().maxCoeff() < 0.016);
        }
    }
}

TEST_CASE("in Box2D what has left a world that wraps comes in at the other side", "[compare][wrap]") {
    Scene scene{.name = "a", .gravity = {0, 0}, .duration = 3, .wrap = {.width = 8, .height = 6}};
    scene.bodies = {{"b", {.position = {7, 1}, .velocity = {1, -1}, .shapes = {circle(0.5)}}}};
    for (const Engine& engine : engines()) {
        if (engine.role == Role::Truth) continue;
        const Observation seen = observe(scene, engine);
        INFO(engine.name);
        CHECK((seen.states.back()[0].position - Vec2(2, 4)).norm() < 1e-4);
    }
}

TEST_CASE("discs that overlap by 0.1 m across the seam, or the corner, of a world are said to", "[compare][wrap]") {
    const auto scene = [](const Vec2& other) {
        Scene wrapped{.name = "a", .gravity = {0, 0}, .wrap = {.width = 8, .height = 6}};
        wrapped.bodies = {{"a", {.position = {7.6, 5.7}, .shapes = {circle(0.5)}}},
                          {"b", {.position = other, .shapes = {circle(0.5)}}}};
        return wrapped;
    };
    const auto overlapOf = [&](const Vec2& other) {
        const Scene wrapped = scene(other);
        return Geometry(wrapped).penetration(std::vector<BodyState>{{{7.6, 5.7}}, {other}}).value();
    };
    CHECK(overlapOf({0.5, 5.7}) == Approx(0.1).epsilon(1e-9));
    CHECK(overlapOf({7.6, 0.6}) == Approx(0.1).epsilon(1e-9));
    CHECK(overlapOf({0.14, 0.42}) == Approx(1 - std::hypot(0.54, 0.72)).epsilon(1e-9));
    CHECK(overlapOf({3, 3}) == 0);
}
