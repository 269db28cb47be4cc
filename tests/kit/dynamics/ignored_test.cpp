// SPDX-License-Identifier: MIT
// Can rays and shape casts leave out a body?
#include <stdexcept>
#include <string>

#include <plumb/plumb.h>
#include "catch.h"

using namespace plumb;
using namespace plumb::test;

namespace {

template <class Call>
std::string complaintFrom(Call&& call) {
    try {
        call();
    } catch (const std::invalid_argument& fault) {
        return fault.what();
    }
    return {};
}

/// A tank of a hull, a turret and a chain; a crate 5 m in front of it, and a wall behind the crate.
struct TankRange {
    World world;
    BodyId tank, crate, wall;
};

TankRange tankRange(const WorldDef& def = {}) {
    TankRange r{World(def), {}, {}, {}};
    r.tank = r.world.add({.position = {0, 0}, .shapes = {box({1, 0.5}), circle(0.4), capsule({0, 0}, {1.5, 0}, 0.1)}});
    r.crate = r.world.add({.position = {5, 0}, .shapes = {box({0.5, 0.5})}});
    r.wall = r.world.add({.type = BodyType::Static, .shapes = {chain({{9, 5}, {9, 1}, {9, -1}, {9, -5}})}});
    return r;
}

}  // namespace

TEST_CASE("a ray from within a tank of three shapes sees the crate in front of it if the tank is ignored",
          "[dynamics]") {
    const TankRange r = tankRange();
    const Vec2 from(0, 0), to(20, 0);
    REQUIRE(r.world.castRay(from, to));
    CHECK(r.world.castRay(from, to)->shape.body == r.tank);
    const auto seen = r.world.castRay(from, to, {}, r.tank);
    REQUIRE(seen);
    CHECK(seen->shape.body == r.crate);
    CHECK(seen->point.x() == 4.5);
    CHECK(r.world.castRayAll(from, to).size() == 5);
    const auto all = r.world.castRayAll(from, to, {}, r.tank);
    REQUIRE(all.size() == 2);
    CHECK(all[0].shape == ShapeId{r.crate, 0});
    CHECK(all[1].shape == ShapeId{r.wall, 0});
    CHECK(r.world.castRayAll(from, to, {}, r.wall).size() == 4);
    CHECK_FALSE(r.world.castRay(from, {4, 0}, {}, r.tank));
}

TEST_CASE("a shape cast from within a tank sees the crate in front of it if the tank is ignored", "[dynamics]") {
    const TankRange r = tankRange();
    const Shape disc = Circle{0.25};
    CHECK(r.world.castShape(disc, {}, {20, 0})->shape.body == r.tank);
    const auto seen = r.world.castShape(disc, {}, {20, 0}, {}, r.tank);
    REQUIRE(seen);
    CHECK(seen->shape.body == r.crate);
    CHECK(seen->fraction * 20 < 4.25 + 1e-6);
    CHECK(seen->fraction * 20 > 4.25 - 1e-6);
    CHECK(r.world.castShapeAll(disc, {}, {20, 0}).size() == 5);
    CHECK(r.world.castShapeAll(disc, {}, {20, 0}, {}, r.tank).size() == 2);
    CHECK(r.world.castShapeAll(disc, {}, {20, 0}, {}, r.crate).size() == 4);
}

TEST_CASE("all images of an ignored body are left out in a world that wraps", "[dynamics]") {
    const TankRange r = tankRange({.wrap = {.width = 30}});
    for (const CastHit& hit : r.world.castRayAll({0, 0}, {70, 0}, {}, r.tank)) CHECK(hit.shape.body != r.tank);
    CHECK(r.world.castRay({6, 0}, {31, 0}, {}, r.wall)->shape.body == r.tank);
    CHECK_FALSE(r.world.castRay({10, 0}, {33, 0}, {}, r.tank));
}

TEST_CASE("a body that was removed cannot be ignored by a cast", "[dynamics]") {
    TankRange r = tankRange();
    r.world.remove(r.crate);
    const Shape disc = Circle{0.25};
    CHECK_THAT(complaintFrom([&] {
                   (void)r.world.castRay({0, 0}, {9, 0}, {}, r.crate);
               }),
               containsText("World.castRay: ignored"));
    CHECK_THAT(complaintFrom([&] {
                   (void)r.world.castRayAll({0, 0}, {9, 0}, {}, r.crate);
               }),
               containsText("World.castRayAll: ignored"));
    CHECK_THAT(complaintFrom([&] {
                   (void)r.world.castShape(disc, {}, {9, 0}, {}, r.crate);
               }),
               containsText("World.castShape: ignored"));
    CHECK_THAT(complaintFrom([&] {
                   (void)r.world.castShapeAll(disc, {}, {9, 0}, {}, r.crate);
               }),
               containsText("World.castShapeAll: ignored"));
}
