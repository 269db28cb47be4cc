// SPDX-License-Identifier: MIT
#include <plumb/space/shape_def.h>

#include <limits>
#include <stdexcept>

#include "catch.h"

using plumb::Material;
using plumb::ShapeDef;
using plumb::Vec2;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

void check(const Material& material) {
    plumb::validate(plumb::circle(1, material), "BodyDef.shapes[0]");
}

}  // namespace

TEST_CASE("each short form makes its shape, with its material", "[space]") {
    const Material rubber{.density = 3, .friction = 0.9, .restitution = 0.7};
    const ShapeDef circle = plumb::circle(2, rubber);
    CHECK(std::get<plumb::Circle>(circle.shape).radius == 2);
    CHECK(std::get<plumb::Circle>(circle.shape).center == Vec2(0, 0));
    CHECK(circle.material.restitution == 0.7);

    const ShapeDef box = plumb::box({2, 1}, rubber);
    REQUIRE(std::get<plumb::Polygon>(box.shape).vertices.size() == 4);
    CHECK(std::get<plumb::Polygon>(box.shape).vertices[2] == Vec2(2, 1));
    CHECK(box.material.density == 3);

    const ShapeDef triangle = plumb::polygon({{0, 0}, {1, 0}, {0, 1}}, rubber);
    CHECK(std::get<plumb::Polygon>(triangle.shape).vertices[1] == Vec2(1, 0));
    CHECK(triangle.material.friction == 0.9);

    const ShapeDef line = plumb::segment({-1, 0}, {1, 0}, rubber);
    CHECK(std::get<plumb::Segment>(line.shape).start == Vec2(-1, 0));
    CHECK(std::get<plumb::Segment>(line.shape).end == Vec2(1, 0));
    const ShapeDef capsule = plumb::capsule({-1, 0}, {1, 0}, 0.25, rubber);
    CHECK(std::get<plumb::Capsule>(capsule.shape).end == Vec2(1, 0));
    CHECK(std::get<plumb::Capsule>(capsule.shape).radius == 0.25);

    const ShapeDef rounded = plumb::roundedBox({2, 1}, 0.5, rubber);
    CHECK(std::get<plumb::Polygon>(rounded.shape).vertices[2] == Vec2(2, 1));
    CHECK(std::get<plumb::Polygon>(rounded.shape).radius == 0.5);
    const ShapeDef soft = plumb::roundedPolygon({{0, 0}, {1, 0}, {0, 1}}, 0.125, rubber);
    CHECK(std::get<plumb::Polygon>(soft.shape).vertices[1] == Vec2(1, 0));
    CHECK(std::get<plumb::Polygon>(soft.shape).radius == 0.125);

    const ShapeDef floor = plumb::chain({{0, 0}, {10, 0}});
    CHECK(std::get<plumb::Chain>(floor.shape).points[1] == Vec2(10, 0));
    CHECK_FALSE(std::get<plumb::Chain>(floor.shape).closed);
    const ShapeDef ring = plumb::loop({{0, 0}, {1, 0}, {0, 1}}, rubber);
    CHECK(std::get<plumb::Chain>(ring.shape).closed);
    CHECK(ring.material.density == 3);
    for (const ShapeDef& def : {circle, box, triangle, line, capsule, rounded, soft, floor, ring})
        CHECK_NOTHROW(plumb::validate(def, "ShapeDef"));
}

TEST_CASE("materials that no matter has are refused by name", "[space][errors]") {
    const std::string prefix = "BodyDef.shapes[0].material.";
    CHECK_NOTHROW(check({.density = 0, .friction = 0, .restitution = 0}));
    CHECK_NOTHROW(check({.density = 1e6, .friction = 100, .restitution = 1}));
    CHECK_THROWS_AS(check({.density = -1}), std::invalid_argument);
    CHECK_THROWS_WITH(check({.density = -1}), prefix + "density: -1 is negative");
    CHECK_THROWS_WITH(check({.density = infinity}), prefix + "density: inf is not finite");
    CHECK_THROWS_WITH(check({.friction = -0.1}), prefix + "friction: -0.1 is negative");
    CHECK_THROWS_WITH(check({.friction = notANumber}), prefix + "friction: nan is not finite");
    CHECK_THROWS_WITH(check({.restitution = 1.01}),
                      prefix +
                          "restitution: 1.01 is not within 0 to 1; for a bumper, which adds speed, apply an "
                          "impulse at each ContactBegin: see dynamics/events.md, Bumpers");
    CHECK_THROWS_WITH(check({.restitution = -0.5}), prefix + "restitution: -0.5 is not within 0 to 1");
    CHECK_THROWS_WITH(check({.restitution = notANumber}), prefix + "restitution: nan is not finite");
    CHECK_NOTHROW(check({.rollingResistance = 0.5, .surfaceSpeed = -3}));
    CHECK_THROWS_WITH(check({.rollingResistance = -1}), prefix + "rollingResistance: -1 is negative");
    CHECK_THROWS_WITH(check({.surfaceSpeed = infinity}), prefix + "surfaceSpeed: inf is not finite");
}

TEST_CASE("a def with a bad shape is refused by the shape's path", "[space][errors]") {
    CHECK_THROWS_WITH(plumb::validate(plumb::circle(-1), "BodyDef.shapes[0]"),
                      "BodyDef.shapes[0].shape.radius: -1 is not positive");
    CHECK_THROWS_WITH(plumb::validate(plumb::segment({1, 1}, {1, 1}), "ShapeDef"),
                      "ShapeDef.shape.end: (1, 1) is the same point as start");
    CHECK_THROWS_WITH(plumb::validate(plumb::polygon({{0, 0}, {0, 1}, {1, 0}}), "ShapeDef"),
                      "ShapeDef.shape.vertices: the corners run clockwise, not counter-clockwise");
    CHECK_THROWS_WITH(plumb::box({-1, 1}), "box.halfSize: (-1, 1) is not positive");
}
