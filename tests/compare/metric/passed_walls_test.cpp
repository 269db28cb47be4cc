// SPDX-License-Identifier: MIT
#include <compare/metric/passed_walls.h>

#include <limits>

#include "catch.h"

namespace plumb::compare {
namespace {

/// A bin 10 m wide and 5 m high, open above, with walls 1 m thick, and a disc.
Scene bin() {
    Scene scene{.name = "bin"};
    scene.bodies.push_back(
        {"bin",
         {.type = BodyType::Static,
          .shapes = {ShapeDef{boxPolygon({6, 0.5}, {0, -0.5})}, ShapeDef{boxPolygon({0.5, 2.5}, {-5.5, 2.5})},
                     ShapeDef{boxPolygon({0.5, 2.5}, {5.5, 2.5})}}}});
    scene.bodies.push_back({"disc", {.shapes = {circle(0.25)}}});
    return scene;
}

std::optional<std::size_t> passed(const Scene& scene, const Vec2& place) {
    std::vector<BodyState> states(scene.bodies.size());
    states.back().position = place;
    return PassedWalls(scene).count(states);
}

}  // namespace

TEST_CASE("a body in a wall, beyond it or below the floor has passed it, one in the bin or over it has not",
          "[compare][metric]") {
    const Scene scene = bin();
    for (const Vec2& place : {Vec2(0, 0.2), Vec2(-4.9, 3), Vec2(0, 100), Vec2(5.5, 7), Vec2(0, 0)})
        CHECK(passed(scene, place) == std::size_t{0});
    for (const Vec2& place : {Vec2(0, -0.5), Vec2(0, -3), Vec2(5.5, 2), Vec2(7, 2), Vec2(-7, 100)})
        CHECK(passed(scene, place) == std::size_t{1});
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(passed(scene, {nan, 0}) == std::size_t{1});
}

TEST_CASE("without gravity nothing leaves above either", "[compare][metric]") {
    Scene scene = bin();
    scene.gravity = {0, 0};
    CHECK(passed(scene, {0, 6}) == std::size_t{1});
    CHECK(passed(scene, {0, 4}) == std::size_t{0});
}

TEST_CASE("what the body passes by its filter is no wall to it, and neither is a sensor", "[compare][metric]") {
    Scene scene = bin();
    scene.bodies.push_back({"mark", {.type = BodyType::Static, .position = {0, 2}, .shapes = {box({1, 1})}}});
    std::swap(scene.bodies[1], scene.bodies[2]);
    CHECK(passed(scene, {0, 2}) == std::size_t{0});  // the states have the mark at the origin
    std::vector<BodyState> states(3);
    states[1].position = states[2].position = {0, 2};
    CHECK(PassedWalls(scene).count(states) == std::size_t{1});
    scene.bodies[1].def.shapes[0].filter.mask = 0;
    CHECK(PassedWalls(scene).count(states) == std::size_t{0});
    scene.bodies[1].def.shapes[0] = box({1, 1});
    scene.bodies[1].def.shapes[0].sensor = true;
    CHECK(PassedWalls(scene).count(states) == std::size_t{0});
}

TEST_CASE("a scene without walls, and one that goes on at its other side, has no number", "[compare][metric]") {
    Scene scene = bin();
    scene.wrap.width = 20;
    CHECK_FALSE(passed(scene, {0, 0}));
    scene = bin();
    scene.bodies.erase(scene.bodies.begin());
    CHECK_FALSE(passed(scene, {0, 0}));
}

TEST_CASE("a body that has not appeared yet has passed nothing", "[compare][metric]") {
    const Scene scene = bin();
    std::vector<BodyState> states(2);
    states[1].position = {0, -9};
    states[1].present = false;
    CHECK(PassedWalls(scene).count(states) == std::size_t{0});
}

}  // namespace plumb::compare
