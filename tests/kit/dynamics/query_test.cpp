// SPDX-License-Identifier: MIT
#include <plumb/dynamics/query.h>

#include <numbers>
#include <stdexcept>

#include <plumb/dynamics/world.h>

#include "catch.h"
#include "numbers.h"

namespace plumb::test {

namespace {

BodyId addBox(World& world, const Vec2& place, const Filter& filter = {}, BodyType type = BodyType::Static) {
    ShapeDef shape = box({0.5, 0.5});
    shape.filter = filter;
    return world.add({.type = type, .position = place, .shapes = {shape}});
}

template <class Call>
std::string complaintOf(Call&& call) {
    try {
        call();
    } catch (const std::invalid_argument& refused) {
        return refused.what();
    }
    return "nothing";
}

}  // namespace

TEST_CASE("a ray finds what was added, has jumped here or was removed, without a step between", "[dynamics]") {
    World world;
    const BodyId near = addBox(world, {5, 0}), far = addBox(world, {8, 0});
    REQUIRE(world.castRay({0, 0}, {10, 0}));
    CHECK(world.castRay({0, 0}, {10, 0})->shape == ShapeId{near, 0});
    CHECK(world.castRay({0, 0}, {10, 0})->fraction == 0.45);
    world.body(far).setPose({3, 0}, 0);
    CHECK(world.castRay({0, 0}, {10, 0})->shape == ShapeId{far, 0});
    world.remove(far);
    CHECK(world.castRay({0, 0}, {10, 0})->shape == ShapeId{near, 0});
    world.step(1.0 / 60);
    CHECK(world.castRay({0, 0}, {10, 0})->shape == ShapeId{near, 0});
    world.remove(near);
    CHECK_FALSE(world.castRay({0, 0}, {10, 0}));
}

TEST_CASE(
    "a box at rest that was struck at 500 m/s in the last step is found where it has flown to, until it is disabled",
    "[dynamics]") {
    World world({.gravity = {0, 0}});
    const BodyId struck = addBox(world, {0, 0}, {}, BodyType::Dynamic);
    ShapeDef hammer = circle(0.5, {.density = 1000, .restitution = 1});
    world.add({.position = {-3, 0}, .velocity = {500, 0}, .shapes = {hammer}});
    world.step(1.0 / 60);
    const Vec2 now = world.body(struck).position();
    REQUIRE(now.x() > 3);
    CHECK(world.overlapPoint(now) == std::vector{ShapeId{struck, 0}});
    CHECK(world.castRay(now + Vec2(0, 5), now)->shape == ShapeId{struck, 0});
    CHECK(world.nearest(now, 0)->shape == ShapeId{struck, 0});
    world.body(struck).setEnabled(false);
    CHECK(world.overlapPoint(now).empty());
    CHECK_FALSE(world.castRay(now + Vec2(0, 5), now));
    CHECK_FALSE(world.nearest(now, 0));
}

TEST_CASE("it is found there too when its centre of mass is put back to where it was before the step", "[dynamics]") {
    World world({.gravity = {0, 0}});
    const BodyId struck = addBox(world, {0, 0}, {}, BodyType::Dynamic);
    const ShapeDef hammer = circle(0.5, {.density = 1000, .restitution = 1});
    world.add({.position = {-3, 0}, .velocity = {500, 0}, .shapes = {hammer}});
    world.step(1.0 / 60);
    const Vec2 now = world.body(struck).position();
    REQUIRE(now.x() > 3);
    world.body(struck).setMass({1, -now, 1});
    REQUIRE(world.body(struck).position() == now);
    CHECK(world.overlapPoint(now) == std::vector{ShapeId{struck, 0}});
    CHECK(world.castRay(now + Vec2(0, 5), now));
}

TEST_CASE("a body that was made asleep, and flies on when it is touched, is found where it has flown to",
          "[dynamics]") {
    World world({.gravity = {0, 0}});
    const BodyId sleeper = world.add({.velocity = {20, 0}, .awake = false, .shapes = {box({0.5, 0.5})}});
    world.add({.position = {-1.0, 0}, .velocity = {1, 0}, .shapes = {box({0.5, 0.5})}});
    world.step(1.0 / 60);
    const Vec2 now = world.body(sleeper).position();
    REQUIRE(world.body(sleeper).awake());
    REQUIRE(now.x() > 0.2);
    CHECK(world.overlapPoint(now + Vec2(0.49, 0)) == std::vector{ShapeId{sleeper, 0}});
    CHECK(world.castRay(now + Vec2(0.45, 5), now + Vec2(0.45, 0)));
}

TEST_CASE("of shapes met at once the one of the first body is found, and of one body the first shape", "[dynamics]") {
    World world;
    const BodyId first = world.add(
        {.type = BodyType::Static, .position = {5, 0}, .shapes = {circle(0.25), box({0.5, 0.5}), box({0.5, 0.5})}});
    const BodyId second = addBox(world, {5, 0});
    CHECK(world.castRay({0, 0}, {10, 0})->shape == ShapeId{first, 1});
    const std::vector<CastHit> all = world.castRayAll({0, 0}, {10, 0});
    REQUIRE(all.size() == 4);
    CHECK(all[0].shape == ShapeId{first, 1});
    CHECK(all[1].shape == ShapeId{first, 2});
    CHECK(all[2].shape == ShapeId{second, 0});
    CHECK(all[3].shape == ShapeId{first, 0});
    const std::vector<ShapeId> here = world.overlapPoint({5, 0});
    CHECK(here == std::vector{ShapeId{first, 0}, ShapeId{first, 1}, ShapeId{first, 2}, ShapeId{second, 0}});
}

TEST_CASE("a chain of six segments is one shape to every query", "[dynamics]") {
    World world;
    const BodyId body = world.add(
        {.type = BodyType::Static, .shapes = {chain({{0, 0}, {1, 1}, {2, 0}, {3, 1}, {4, 0}, {5, 1}, {6, 0}})}});
    const ShapeId line{body, 0};
    const std::vector<CastHit> hits = world.castRayAll({-1, 0.5}, {7, 0.5});
    REQUIRE(hits.size() == 1);
    CHECK(hits[0].shape == line);
    CHECK(hits[0].point == Vec2(0.5, 0.5));
    CHECK(world.castShapeAll(Circle{0.25}, {{-1, 0.5}, {}}, {8, 0}).size() == 1);
    CHECK(world.overlapBox({{-1, 0}, {7, 1}}) == std::vector{line});
    CHECK(world.overlapShape(Circle{3}, {{3, 0}, {}}) == std::vector{line});
    CHECK(world.nearest({3, 2}, 10)->point == Vec2(3, 1));
}

TEST_CASE("a query meets what its filter would collide with, and no sensor", "[dynamics]") {
    World world;
    const BodyId plain = addBox(world, {1, 0}), second = addBox(world, {3, 0}, {.category = 2});
    const BodyId shy = addBox(world, {5, 0}, {.mask = 4}), grouped = addBox(world, {7, 0}, {.mask = 0, .group = 5});
    ShapeDef sensor = box({0.5, 0.5});
    sensor.sensor = true;
    world.add({.type = BodyType::Static, .position = {9, 0}, .shapes = {sensor}});
    const auto found = [&](const Filter& filter) {
        std::vector<BodyId> bodies;
        for (const CastHit& hit : world.castRayAll({0, 0}, {10, 0}, filter)) bodies.push_back(hit.shape.body);
        return bodies;
    };
    CHECK(found({}) == std::vector{plain, second});
    CHECK(found({.category = 4}) == std::vector{plain, second, shy});
    CHECK(found({.mask = 2}) == std::vector{second});
    CHECK(found({.mask = 0, .group = 5}) == std::vector{grouped});
    CHECK(found({.group = -5}) == std::vector{plain, second});
}

TEST_CASE("what just touches a box, a shape or a point overlaps it, what is 1e-9 m off does not", "[dynamics]") {
    World world;
    const BodyId body = addBox(world, {2, 0});
    const std::vector<ShapeId> it{{body, 0}};
    CHECK(world.overlapBox({{0, 0}, {1.5, 1}}) == it);
    CHECK(world.overlapBox({{0, 0}, {1.5 - 1e-9, 1}}).empty());
    CHECK(world.overlapBox({{1.5, -2}, {1.5, 2}}) == it);
    CHECK(world.overlapBox({{2, 0.5}, {2, 0.5}}) == it);
    CHECK(world.overlapPoint({1.5, 0.5}) == it);
    CHECK(world.overlapPoint({1.5 - 1e-9, 0.5}).empty());
    CHECK(world.overlapShape(Circle{0.5}, {{1, 0}, {}}) == it);
    CHECK(world.overlapShape(Circle{0.5}, {{1 - 1e-9, 0}, {}}).empty());
    CHECK(world.nearest({0, 0}, 1.5)->separation == 1.5);
    CHECK_FALSE(world.nearest({0, 0}, 1.5 - 1e-9));
    CHECK(world.nearest({2, 0.25}, 0)->separation == -0.25);
}

TEST_CASE("a ray of 2e12 m through a world of 3 m meets a box as a short one does", "[dynamics]") {
    World world;
    const BodyId body = addBox(world, {2, 0});
    world.step(1.0 / 60);
    const std::optional<CastHit> hit = world.castRay({-1e12, 0.25}, {1e12, 0.25});
    REQUIRE(hit);
    CHECK(hit->shape.body == body);
    CHECK(std::fabs(hit->point.x() - 1.5) < 1e-3);  // of 1e12 m, a double tells 1e-4
    CHECK_FALSE(world.castRay({-1e12, 0.75}, {1e12, 0.75}));
}

TEST_CASE("a ray and a disc still meet the floor after a ball was put 1e99 m away", "[dynamics]") {
    World world;
    const BodyId floor = world.add({.type = BodyType::Static, .shapes = {segment({-12, 0}, {12, 0})}});
    const BodyId ball = world.add({.position = {0, 5}, .shapes = {circle(0.5)}});
    world.step(1.0 / 60);
    world.body(ball).setPose({-2e99, -8e99}, 0);
    for (int tick = 0; tick < 3; ++tick) {
        world.step(1.0 / 60);
        REQUIRE(world.castRay({0, 1}, {1, -1}));
        CHECK(world.castRay({0, 1}, {1, -1})->shape.body == floor);
        CHECK(world.castShape(Circle{0.25}, {{0, 1}, {}}, {1, -2}));
        CHECK(world.nearest({0, 1}, 2));
        CHECK(world.overlapPoint({0, 0}).size() == 1);
    }
    CHECK(world.body(ball).quarantined());
}

TEST_CASE("of a chain of three links a cast's pieces are three hits, all of it one, of a body that is ignored none",
          "[dynamics]") {
    World world;
    const BodyId hills = world.add({.type = BodyType::Static, .shapes = {chain({{6, 0}, {4, 1}, {2, 0}, {0, 1}})}});
    const BodyId crate = addBox(world, {8, 0.5});
    const Shape ball = Circle{0.4};
    const Vec2 from(-2, 0.5), shift(20, 0);
    CHECK(world.castShapeAll(ball, {from, {}}, shift).size() == 2);
    const std::vector<CastHit> pieces = world.castShapePieces(ball, {from, {}}, shift);
    REQUIRE(pieces.size() == 4);
    for (std::size_t i = 0; i < 4; ++i) CHECK(pieces[i].shape == ShapeId{i < 3 ? hills : crate, 0});
    for (std::size_t i = 1; i < 4; ++i) CHECK(pieces[i - 1].fraction <= pieces[i].fraction);
    CHECK(world.castShapePieces(ball, {from, {}}, shift, {}, hills).size() == 1);
    CHECK(world.castShapePieces(ball, {from, {}}, shift, {}, crate).size() == 3);
    world.remove(crate);
    CHECK_THAT(complaintOf([&] {
                   world.castShapePieces(ball, {from, {}}, shift, {}, crate);
               }),
               containsText("World.castShapePieces: ignored"));
}

TEST_CASE("a hit names the way from which alone what was met is solid, as the world sees it", "[dynamics]") {
    World world({.gravity = {0, 0}});
    ShapeDef slab = box({1, 0.1});
    world.add({.type = BodyType::Static, .position = {0, 5}, .shapes = {slab}});
    slab.oneWay = Vec2(0, 2);
    world.add({.type = BodyType::Static, .position = {5, 5}, .angle = std::numbers::pi / 2, .shapes = {slab}});
    const auto solid = world.castRay({0, 0}, {0, 10}), open = world.castRay({5, 0}, {5, 10});
    REQUIRE((solid && open));
    CHECK_FALSE(solid->oneWay);
    REQUIRE(open->oneWay);
    CHECK((*open->oneWay - Vec2(-2, 0)).norm() < 1e-15);
}

}  // namespace plumb::test
