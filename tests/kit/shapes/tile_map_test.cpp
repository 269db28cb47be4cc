// SPDX-License-Identifier: MIT
#include <limits>
#include <string>
#include <vector>

#include <plumb/shapes/aabb.h>
#include <plumb/shapes/mass.h>
#include <plumb/shapes/shape.h>
#include <plumb/shapes/tile_text.h>
#include "catch.h"

using namespace plumb;
using namespace plumb::test;

namespace {

constexpr Tile full{.form = TileForm::Full};

double areaOfCorners(const std::vector<Vec2>& corners) {
    double twice = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return twice / 2;
}

}  // namespace

TEST_CASE("a text of three rows is a map with its last row below, and is written back as it was", "[shapes][tiles]") {
    const std::vector<std::string> rows{"..=..", "/#~^\\", "12#34"};
    const TileMap map = tileMapOf(rows, 0.5);
    CHECK(map.columns() == 5);
    CHECK(map.rows() == 3);
    CHECK(map.size() == 0.5);
    CHECK(map.at({0, 0}).form == TileForm::GentleUpLow);
    CHECK(map.at({4, 0}).form == TileForm::GentleDownLow);
    CHECK(map.at({0, 1}).form == TileForm::SlopeUp);
    CHECK(map.at({2, 1}).kind == TileKind::Sensor);
    CHECK(map.at({3, 1}).kind == TileKind::Hazard);
    CHECK(map.at({2, 2}).kind == TileKind::OneWay);
    CHECK(textOf(map) == rows);
    CHECK(tileMapOf(std::string_view("  =  \n/#~^\\\r\n12#34\n"), 0.5) == map);
}

TEST_CASE("rows of different lengths end in empty cells, and cells outside of the map are empty", "[shapes][tiles]") {
    const TileMap map = tileMapOf({"#", "###"});
    CHECK(map.columns() == 3);
    CHECK(isEmpty(map.at({2, 1})));
    CHECK(isEmpty(map.at({-1, 0})));
    CHECK(isEmpty(map.at({0, 2})));
    CHECK_FALSE(map.contains({3, 0}));
}

TEST_CASE("a map that wraps in x has its last column at the left of its first", "[shapes][tiles]") {
    const TileMap map = tileMapOf({"  #"}).wrapping(true, false);
    CHECK(map.at({-1, 0}) == full);
    CHECK(map.at({5, 0}) == full);
    CHECK(map.at({-301, 0}) == full);
    CHECK(map.wrapped({-4, 7}) == Cell{2, 7});
    CHECK(isEmpty(map.at({-1, 1})));
}

TEST_CASE("a point is in the cell to the right of and above the lines it lies on, far outside too", "[shapes][tiles]") {
    const TileMap map({.columns = 4, .rows = 4, .size = 0.25});
    CHECK(map.cellAt({0, 0}) == Cell{0, 0});
    CHECK(map.cellAt({0.25, 0.499}) == Cell{1, 1});
    CHECK(map.cellAt({-1e-9, 1}) == Cell{-1, 4});
    CHECK(map.cellAt({1e300, -1e300}).column == std::numeric_limits<int>::max());
    CHECK(map.centerOf({1, 2}) == Vec2(0.375, 0.625));
}

TEST_CASE("forms fill 0, 1, 1/2, 1/4 and 3/4 of their cells, hanging or not", "[shapes][tiles]") {
    const auto share = [](TileForm form, bool hanging) {
        return areaOfCorners(cornersOf(Tile{.form = form, .upsideDown = hanging}));
    };
    for (const bool hanging : {false, true}) {
        CHECK(share(TileForm::Empty, hanging) == 0);
        CHECK(share(TileForm::Full, hanging) == 1);
        CHECK(share(TileForm::SlopeUp, hanging) == 0.5);
        CHECK(share(TileForm::SlopeDown, hanging) == 0.5);
        CHECK(share(TileForm::GentleUpLow, hanging) == 0.25);
        CHECK(share(TileForm::GentleUpHigh, hanging) == 0.75);
        CHECK(share(TileForm::GentleDownHigh, hanging) == 0.75);
        CHECK(share(TileForm::GentleDownLow, hanging) == 0.25);
    }
}

TEST_CASE("what is no map is refused, by the field's name", "[shapes][tiles]") {
    CHECK_THROWS_WITH(TileMap({.columns = 0}), containsText("TileMapDef.columns: 0"));
    CHECK_THROWS_WITH(TileMap({.rows = -3}), containsText("TileMapDef.rows: -3"));
    CHECK_THROWS_WITH(TileMap({.size = 0}), containsText("TileMapDef.size: 0"));
    CHECK_THROWS_WITH(TileMap({.columns = 100, .size = 1e307}), containsText("inf"));
    CHECK_THROWS_WITH(TileMap({.columns = 1 << 20, .rows = 1 << 20}), containsText("2^24"));
    CHECK_THROWS_WITH(tileMapOf({"#", "#?"}), containsText("rows[1][1]: '?'"));
    CHECK_THROWS_WITH(tileMapOf(std::vector<std::string>{}), containsText("hold no cell"));
    TileMap map({.columns = 2, .rows = 2});
    CHECK_THROWS_WITH(map.set({2, 0}, full), containsText("(2, 0)"));
    map.set({0, 0}, {.form = TileForm::SlopeUp, .upsideDown = true});
    CHECK_THROWS_WITH(textOf(map), containsText("no letter"));
}

TEST_CASE("a map as a shape has its grid's box and no mass", "[shapes][tiles]") {
    const Shape shape = tileMapOf({"#  ", "   "}, 2);
    const Aabb box = aabbOf(shape, {{1, 1}, {}});
    CHECK(box.lower == Vec2(1, 1));
    CHECK(box.upper == Vec2(7, 5));
    CHECK(massOf(shape, 1).mass == 0);
}
