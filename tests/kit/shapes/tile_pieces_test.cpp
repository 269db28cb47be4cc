// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <vector>

#include <plumb/math/random.h>
#include <plumb/shapes/tile_pieces.h>
#include "cases.h"
#include "catch.h"

using namespace plumb;
using namespace plumb::test;

namespace {

constexpr double step = 1e-3;  ///< to either side of an outline [cells]

bool isInside(const std::vector<Vec2>& corners, const Vec2& point) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 edge = corners[(i + 1) % corners.size()] - corners[i], from = point - corners[i];
        if (edge.x() * from.y() - edge.y() * from.x() < 0) return false;
    }
    return !corners.empty();
}

/// By the cell's own tile.
bool isSolidAt(const TileMap& map, const Vec2& point) {
    const Cell cell = map.cellAt(point);
    return isSolid(map.at(cell)) && isInside(map.cornersOf(cell), point);
}

Tile randomTile(Random& random, bool allKinds) {
    if (random.integer(0, 2) == 0) return {};
    Tile tile;
    tile.form = random.integer(0, 1) == 0 ? TileForm::Full : static_cast<TileForm>(random.integer(1, 7));
    tile.upsideDown = random.integer(0, 3) == 0;
    if (allKinds) tile.kind = static_cast<TileKind>(random.integer(0, 3));
    return tile;
}

TileMap randomMap(Random& random, bool allKinds) {
    TileMap map({.columns = random.integer(1, 40),
                 .rows = random.integer(1, 40),
                 .wrapX = random.integer(0, 2) == 0,
                 .wrapY = random.integer(0, 2) == 0});
    for (int row = 0; row < map.rows(); ++row)
        for (int column = 0; column < map.columns(); ++column) map.set({column, row}, randomTile(random, allKinds));
    return map;
}

Vec2 outwardOf(const Segment& s) {
    const Vec2 along = (s.end - s.start).normalized();
    return {along.y(), -along.x()};
}

/// Of all sides of all tiles, in parts that are open or covered as a whole, those with nothing solid beyond them.
double openLength(const TileMap& map) {
    constexpr int parts = 4;
    double length = 0;
    for (int row = 0; row < map.rows(); ++row) {
        for (int column = 0; column < map.columns(); ++column) {
            const std::vector<Vec2> corners = map.cornersOf({column, row});
            if (!isSolid(map.at({column, row}))) continue;
            for (std::size_t i = 0; i < corners.size(); ++i) {
                const Vec2 start = corners[i], side = corners[(i + 1) % corners.size()] - start;
                const Vec2 outward = Vec2(side.y(), -side.x()).normalized();
                for (int part = 0; part < parts; ++part)
                    if (!isSolidAt(map, start + side * ((part + 0.5) / parts) + step * outward))
                        length += side.norm() / parts;
            }
        }
    }
    return length;
}

bool isNear(const Vec2& a, const Vec2& b) {
    return (a - b).norm() < 1e-9;
}

/// At the same point of a map that wraps.
bool isSamePoint(const TileMap& map, const Vec2& a, const Vec2& b) {
    Vec2 apart = a - b;
    if (map.def().wrapX) apart.x() -= map.columns() * std::round(apart.x() / map.columns());
    if (map.def().wrapY) apart.y() -= map.rows() * std::round(apart.y() / map.rows());
    return apart.norm() < 1e-9;
}

Vec2 directionOf(const Segment& s) {
    return (s.end - s.start).normalized();
}

std::vector<Segment> outlineOfPieces(const std::vector<TilePiece>& pieces) {
    std::vector<Segment> outline;
    for (const TilePiece& piece : pieces)
        if (const auto* segment = std::get_if<Segment>(&piece.shape)) outline.push_back(*segment);
    return outline;
}

}  // namespace

TEST_CASE("the outline of 1,000 random maps has what is solid on its left alone, and all of its length",
          "[shapes][tiles]") {
    for (int seed = 0; seed < cases(1000); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const TileMap map = randomMap(random, false);
        double length = 0;
        INFO("seed " << seed);
        for (const Segment& s : outlineOfPieces(tilePiecesOf(map))) {
            length += (s.end - s.start).norm();
            for (const double part : {0.02, 0.37, 0.98}) {
                const Vec2 point = s.start + part * (s.end - s.start), outward = outwardOf(s);
                REQUIRE(isSolidAt(map, point - step * outward));
                REQUIRE_FALSE(isSolidAt(map, point + step * outward));
            }
        }
        REQUIRE(length == Approx(openLength(map)).epsilon(1e-9));
    }
}

TEST_CASE("every piece of the outlines of 1,000 random maps goes on where another begins, and as one when in line",
          "[shapes][tiles]") {
    for (int seed = 0; seed < cases(1000); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const TileMap map = randomMap(random, false);
        const std::vector<Segment> outline = outlineOfPieces(tilePiecesOf(map));
        INFO("seed " << seed);
        for (const Segment& s : outline) {
            const auto follows = [&](const Segment& next) {
                return isSamePoint(map, next.start, s.end) &&
                       isNear(directionOf(next), (*s.after - s.end).normalized());
            };
            const auto leads = [&](const Segment& last) {
                return isSamePoint(map, last.end, s.start) &&
                       isNear(directionOf(last), (s.start - *s.before).normalized());
            };
            const bool opens = !map.def().wrapX || !map.def().wrapY;
            if (opens) REQUIRE((s.before && s.after));
            if (s.after) REQUIRE(std::any_of(outline.begin(), outline.end(), follows));
            if (s.before) REQUIRE(std::any_of(outline.begin(), outline.end(), leads));
            if (!s.after || !isNear((*s.after - s.end).normalized(), directionOf(s))) continue;
            // A joint in line lies between two blocks of cells.
            const Vec2 inside = s.end - 0.1 * directionOf(s) - step * outwardOf(s);
            const Vec2 beyond = s.end + 0.1 * directionOf(s) - step * outwardOf(s);
            const Cell a = map.cellAt(inside), b = map.cellAt(beyond);
            const bool sameBlock = a.column / tileBlock == b.column / tileBlock &&
                                   a.row / tileBlock == b.row / tileBlock && map.wrapped(b) == b;
            REQUIRE_FALSE(sameBlock);
        }
    }
}

TEST_CASE("the areas of 1,000 random maps of all kinds of tiles hold the points that their tiles hold",
          "[shapes][tiles]") {
    for (int seed = 0; seed < cases(1000); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const TileMap map = randomMap(random, true);
        const std::vector<TilePiece> pieces = tilePiecesOf(map);
        INFO("seed " << seed);
        for (int i = 0; i < 100; ++i) {
            const Vec2 point(random.uniform(0, map.columns()), random.uniform(0, map.rows()));
            const Tile tile = map.at(map.cellAt(point));
            const bool filled = tile.kind != TileKind::OneWay && isInside(map.cornersOf(map.cellAt(point)), point);
            int found = 0;
            for (const TilePiece& piece : pieces) {
                const auto* polygon = std::get_if<Polygon>(&piece.shape);
                if (polygon == nullptr || !isInside(polygon->vertices, point)) continue;
                ++found;
                REQUIRE(piece.kind == tile.kind);
                REQUIRE(piece.use == (tile.kind == TileKind::Sensor ? PieceUse::Both : PieceUse::Query));
            }
            REQUIRE(found == (filled ? 1 : 0));
        }
    }
}

TEST_CASE("1,000 tiles in a row are one piece of top for every 16 of them, each in line with the next",
          "[shapes][tiles]") {
    TileMap map({.columns = 1000, .rows = 1});
    for (int column = 0; column < 1000; ++column) map.set({column, 0}, {.form = TileForm::Full});
    int tops = 0;
    for (const Segment& s : outlineOfPieces(tilePiecesOf(map)))
        if (s.end.x() < s.start.x()) ++tops;
    CHECK(tops == 63);
}

TEST_CASE(
    "a one-way top goes on into solid ground in line, whose own top is open there and whose sides turn back under it",
    "[shapes][tiles]") {
    const Tile solid{.form = TileForm::Full}, oneWay{.form = TileForm::Full, .kind = TileKind::OneWay};
    TileMap map({.columns = 3, .rows = 1});
    for (const int column : {0, 2}) map.set({column, 0}, solid);
    map.set({1, 0}, oneWay);
    int tops = 0, sides = 0;
    for (const TilePiece& piece : tilePiecesOf(map)) {
        const auto* s = std::get_if<Segment>(&piece.shape);
        if (s == nullptr) continue;
        const Vec2 along = directionOf(*s);
        if (isNear(along, Vec2(-1, 0))) {
            ++tops;
            const bool isOneWay = piece.kind == TileKind::OneWay;
            CHECK(s->before.has_value() == (isOneWay || s->start.x() > 2.5));
            CHECK(s->after.has_value() == (isOneWay || s->end.x() < 0.5));
            if (!isOneWay) continue;
            CHECK(isNear(*s->before, Vec2(2.5, 1)));
            CHECK(isNear(*s->after, Vec2(0.5, 1)));
        }
        if (isNear(s->end, Vec2(1, 1)) && isNear(along, Vec2(0, 1))) {
            ++sides;
            CHECK(isNear(*s->after, Vec2(1.5, 1)));
        }
        if (isNear(s->start, Vec2(2, 1)) && isNear(along, Vec2(0, -1))) {
            ++sides;
            CHECK(isNear(*s->before, Vec2(1.5, 1)));
        }
    }
    CHECK(tops == 3);
    CHECK(sides == 2);
}

TEST_CASE("a one-way top that ends at a wall higher or lower than it leaves the wall's outline as it is",
          "[shapes][tiles]") {
    const Tile solid{.form = TileForm::Full}, oneWay{.form = TileForm::Full, .kind = TileKind::OneWay};
    for (const int row : {0, 2}) {
        TileMap with({.columns = 2, .rows = 3});
        for (int i = 0; i < 2; ++i) with.set({1, i}, solid);
        TileMap without = with;
        with.set({0, row}, oneWay);
        const std::vector<Segment> few = outlineOfPieces(tilePiecesOf(without));
        std::vector<Segment> all = outlineOfPieces(tilePiecesOf(with));
        CHECK(all.size() == few.size() + 1);
        for (const Segment& s : few) CHECK(std::find(all.begin(), all.end(), s) != all.end());
    }
}
