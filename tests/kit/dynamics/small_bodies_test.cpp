// SPDX-License-Identifier: MIT
// From which size on does a body behave?
#include <cmath>

#include <plumb/plumb.h>

#include "catch.h"
#include "kit/dynamics/bad_input.h"

namespace plumb::test {

namespace {

/// Bodies whose thickness is 2 s.
std::vector<ShapeDef> bodiesOf(double s) {
    return {circle(s),
            box({s, s}),
            capsule({-2 * s, 0}, {2 * s, 0}, s),
            roundedBox({s / 2, s / 2}, s / 2),
            box({5 * s, s}),
            roundedPolygon({{-s, -s / 2}, {s, -s / 2}, {s, s / 2}, {-s, s / 2}}, s / 2)};
}

/// Grounds whose top is at y = 0.
std::vector<ShapeDef> groundsOf(double half) {
    TileMap map({.columns = 40, .rows = 1, .size = half / 20});
    for (int i = 0; i < 40; ++i) map.set({i, 0}, {.form = TileForm::Full});
    return {box({half, half}), segment({-half, 0}, {half, 0}), chain({{half, 0}, {0, 0}, {-half, 0}}), tiles(map)};
}

Vec2 placeOf(const ShapeDef& ground, double half) {
    if (std::holds_alternative<Polygon>(ground.shape)) return {0, -half};
    if (const auto* map = std::get_if<TileMap>(&ground.shape)) return {-half, -map->size()};
    return {0, 0};
}

struct Lying {
    double off = 0;  ///< the distance of its lowest point from the ground [m]
    double speed = 0;
    bool awake = true;
};

Lying lyingOf(const ShapeDef& shape, const ShapeDef& ground, double half, double drop) {
    World world;
    world.add({.type = BodyType::Static, .position = placeOf(ground, half), .shapes = {ground}});
    const double height = -aabbOf(shape.shape, {}).lower.y();
    const BodyId body = world.add({.position = {0, height + drop}, .shapes = {shape}});
    for (int i = 0; i < 60 * 8 && (world.body(body).awake() || i < 60); ++i) world.step(1.0 / 60);
    const auto now = world.body(body);
    return {aabbOf(shape.shape, now.pose()).lower.y(), now.velocity().norm(), now.awake()};
}

}  // namespace

// Contacts with fixed bodies are springs of 60 Hz, so what rests has sunk in by g / (2 pi 60 Hz)^2 = 0.069 mm.
TEST_CASE("whatever is as thick as 2 mm rests where it was put, or falls, on any floor", "[dynamics][symptom]") {
    for (const double s : {1e-3, 1.5e-3, 3e-3, 0.01, 0.1, 1.0, 10.0, 100.0}) {
        const double half = 40 * s + 1;
        for (const ShapeDef& ground : groundsOf(half)) {
            for (const ShapeDef& shape : bodiesOf(s)) {
                for (const double drop : {0.0, 0.01, 1.0}) {
                    CAPTURE(s, ground.shape.index(), shape.shape.index(), drop);
                    const Lying lying = lyingOf(shape, ground, half, drop);
                    // The solver's floats have places of 6e-8 of the ground's size.
                    CHECK(std::fabs(lying.off) < 1e-4 + 1e-7 * half);
                    CHECK(lying.speed == 0);
                    CHECK_FALSE(lying.awake);
                }
            }
        }
    }
}

TEST_CASE("a box of 10 um on a floor, which went 9.6 m/s, is refused, with the smallest size and what to do",
          "[dynamics][symptom][errors]") {
    World world;
    const auto add = [&](const ShapeDef& shape) { return refusalOf([&] { world.add({.shapes = {shape}}); }); };
    CHECK(add(box({1e-5, 1e-5})) ==
          "BodyDef.shapes: 1e-05 m is the radius of the largest disc that fits into one, and less than 0.001 m, the "
          "smallest for a dynamic body: use a smaller unit of length, as millimetres, and multiply all lengths and "
          "WorldDef.gravity");
    for (const ShapeDef& shape : bodiesOf(9.9e-4)) CHECK(add(shape).starts_with("BodyDef.shapes: "));
    for (const ShapeDef& shape : bodiesOf(1e-3)) CHECK(add(shape) == "");
    CHECK(add(box({1, 1e-4})) != "");
    CHECK(add(capsule({-1, 0}, {1, 0}, 1e-4)) != "");
    CHECK(add(roundedBox({4e-4, 4e-4}, 4e-4)) != "");
}

TEST_CASE("thin parts of a thick body, thin sensors and small static bodies are allowed", "[dynamics][symptom]") {
    World world;
    const ShapeDef sliver = box({0.1, 1e-4});
    ShapeDef sensor = circle(1e-5);
    sensor.sensor = true;
    const BodyId thick = world.add({.shapes = {circle(0.1), sliver, sensor}});
    CHECK(refusalOf([&] { world.add(thick, sliver); }) == "");
    CHECK(refusalOf([&] { world.add({.type = BodyType::Static, .shapes = {circle(1e-5)}}); }) == "");
    CHECK(refusalOf([&] { world.add({.mass = Mass{1, {0, 0}, 1}, .shapes = {segment({0, 0}, {1, 0})}}); }) == "");
    const BodyId moved = world.add({.type = BodyType::Kinematic, .shapes = {sliver}});
    CHECK(
        refusalOf([&] { world.body(moved).setType(BodyType::Dynamic); }).starts_with("Body.setType: Dynamic, for the"));
    CHECK(world.body(moved).type() == BodyType::Kinematic);
    const BodyId bare = world.add({.mass = Mass{1, {0, 0}, 1}});
    CHECK(refusalOf([&] { world.add(bare, sliver); }).starts_with("ShapeDef.shape: 0.0001 m is the radius"));
    const ShapeId shape = world.body(world.add({.shapes = {circle(1)}})).shapes()[0];
    CHECK(
        refusalOf([&] { world.shape(shape).set(circle(1e-4)); }).starts_with("ShapeDef.shape: 0.0001 m is the radius"));
}

}  // namespace plumb::test
