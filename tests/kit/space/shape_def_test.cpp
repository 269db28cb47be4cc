// SPDX-License-Identifier: MIT
#include <plumb/space/shape_def.h>

#include "catch.h"

using namespace plumb;

TEST_CASE("each short form makes its shape, with its material", "[space]") {
    const Material rubber{.density = 3, .friction = 0.9, .restitution = 0.7};
    const ShapeDef circle = plumb::circle(2, rubber);
    CHECK(std::get<Circle>(circle.shape).radius == 2);
    CHECK(std::get<Circle>(circle.shape).center == Vec2(0, 0));
    CHECK(circle.material.restitution == 0.7);

    const ShapeDef box = plumb::box({2, 1}, rubber);
    REQUIRE(std::get<Polygon>(box.shape).vertices.size() == 4);
    CHECK(std::get<Polygon>(box.shape).vertices[2] == Vec2(2, 1));
    CHECK(box.material.density == 3);

    const ShapeDef triangle = polygon({{0, 0}, {1, 0}, {0, 1}}, rubber);
    CHECK(std::get<Polygon>(triangle.shape).vertices[1] == Vec2(1, 0));
    CHECK(triangle.material.friction == 0.9);

    const ShapeDef line = segment({-1, 0}, {1, 0}, rubber);
    CHECK(std::get<Segment>(line.shape).start == Vec2(-1, 0));
    CHECK(std::get<Segment>(line.shape).end == Vec2(1, 0));
    const ShapeDef capsule = plumb::capsule({-1, 0}, {1, 0}, 0.25, rubber);
    CHECK(std::get<Capsule>(capsule.shape).end == Vec2(1, 0));
    CHECK(std::get<Capsule>(capsule.shape).radius == 0.25);

    const ShapeDef rounded = roundedBox({2, 1}, 0.5, rubber);
    CHECK(std::get<Polygon>(rounded.shape).vertices[2] == Vec2(2, 1));
    CHECK(std::get<Polygon>(rounded.shape).radius == 0.5);
    const ShapeDef soft = roundedPolygon({{0, 0}, {1, 0}, {0, 1}}, 0.125, rubber);
    CHECK(std::get<Polygon>(soft.shape).vertices[1] == Vec2(1, 0));
    CHECK(std::get<Polygon>(soft.shape).radius == 0.125);

    const ShapeDef floor = chain({{0, 0}, {10, 0}});
    CHECK(std::get<Chain>(floor.shape).points[1] == Vec2(10, 0));
    CHECK_FALSE(std::get<Chain>(floor.shape).closed);
    const ShapeDef ring = loop({{0, 0}, {1, 0}, {0, 1}}, rubber);
    CHECK(std::get<Chain>(ring.shape).closed);
    CHECK(ring.material.density == 3);
    for (const ShapeDef& def : {circle, box, triangle, line, capsule, rounded, soft, floor, ring})
        CHECK_NOTHROW(validate(def, "ShapeDef"));
}
