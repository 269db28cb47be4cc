// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <plumb/math/random.h>
#include <plumb/plumb.h>
#include <plumb/shapes/tile_text.h>
#include "cases.h"
#include "catch.h"
#include "kit/usual_world.h"

using namespace plumb;
using namespace plumb::test;

namespace {

constexpr double fastest = 25;  ///< thrown at 8 m/s in x and y, fallen by 20 m [m/s]
constexpr int mapColumns = 24, mapRows = 20;

double fromSegment(const Vec2& point, const Vec2& start, const Vec2& end) {
    const Vec2 along = end - start;
    const double share = std::clamp(along.dot(point - start) / along.squaredNorm(), 0.0, 1.0);
    return (point - start - share * along).norm();
}

/// Of a point to the outline of what fills a cell, also a round of the world away.
double fromTile(const TileMap& map, Cell cell, const Vec2& point) {
    const std::vector<Vec2> corners = map.cornersOf(cell);
    double least = std::numeric_limits<double>::infinity();
    for (const Vec2& round : {Vec2(0, 0), Vec2(mapColumns, 0), Vec2(-mapColumns, 0)})
        for (std::size_t i = 0; i < corners.size(); ++i)
            least = std::min(least, fromSegment(point + round, corners[i], corners[(i + 1) % corners.size()]));
    return least;
}

TileMap randomFormsMap(Random& random) {
    TileMap map({.columns = mapColumns, .rows = mapRows});
    for (int i = 0; i < 220; ++i) {
        const int column = random.integer(0, mapColumns - 1), row = random.integer(0, mapRows - 1);
        const auto form = static_cast<TileForm>(random.integer(0, 7));
        const auto kind = static_cast<TileKind>(random.integer(0, 3));
        map.set({column, row}, {.form = form, .kind = kind, .upsideDown = random.integer(0, 1) == 0});
    }
    return map;
}

void scatter(World& world, Random& random) {
    for (int i = 0; i < 40; ++i) {
        const double size = random.uniform(0.1, 0.3), x = random.uniform(0, mapColumns), y = random.uniform(0, mapRows);
        const double u = random.uniform(-8, 8), v = random.uniform(-8, 8);
        const ShapeDef shapes[] = {circle(size), box({size, size / 2}), capsule({-size, 0}, {size, 0}, size / 2)};
        const BodyDef def{.position = {x, y}, .velocity = {u, v}, .shapes = {shapes[random.integer(0, 2)]}};
        if (world.overlapShape(def.shapes[0].shape, {def.position, {}}).empty()) world.add(def);
    }
}

/// What was told of touches with a map, against the map.
struct Told {
    int touches = 0, unnamed = 0, empty = 0, named = 0;
    int far = 0;  ///< farther from the tile's outline than a tenth of a tile and what the shapes are apart there

    void note(const TileMap& map, bool withMap, const std::optional<Cell>& tile, const Vec2& point, double apart) {
        if (!withMap) {
            named += tile.has_value() ? 1 : 0;
            return;
        }
        ++touches;
        if (!tile) {
            ++unnamed;
            return;
        }
        const Tile met = map.at(*tile);
        if (isEmpty(met) || met.kind == TileKind::Sensor)
            ++empty;
        else
            far += fromTile(map, *tile, point) - std::abs(apart) / 2 > 0.1 ? 1 : 0;
    }
};

}  // namespace

TEST_CASE("touches in 100 random maps of all kinds and forms name a tile that is there, also across the seam",
          "[dynamics][tiles]") {
    Told told;
    for (int seed = 0; seed < cases(1000); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const TileMap map = randomFormsMap(random);
        World world({.wrap = {.width = seed % 2 == 0 ? mapColumns : Wrap{}.width}});
        const BodyId ground = world.add({.type = BodyType::Static, .shapes = {tiles(map)}});
        scatter(world, random);
        const auto ofMap = [ground](ShapeId a, ShapeId b) { return a.body == ground || b.body == ground; };
        for (int tick = 0; tick < 120; ++tick) {
            world.step(dt);
            // Told at the step's end, when what struck may be on its way back.
            for (const auto& e : world.contactBegins())
                told.note(map, ofMap(e.shapeA, e.shapeB), e.tile, e.point, fastest * dt);
            for (const auto& e : world.contactHits())
                told.note(map, ofMap(e.shapeA, e.shapeB), e.tile, e.point, fastest * dt);
        }
        for (const BodyId body : world.bodies()) {
            for (const auto& contact : world.body(body).contacts())
                for (const auto& p : contact.points)
                    told.note(map, ofMap(contact.shapeA, contact.shapeB), p.tile, p.position, p.separation);
        }
    }
    CHECK(told.touches > cases(100'000));
    CHECK(told.unnamed == 0);
    CHECK(told.empty == 0);
    CHECK(told.named == 0);
    // What spins around the end of a stretch may be pressed along the way that is allowed there, far from the nearest.
    CHECK(told.far * 10'000 <= told.touches);
}

TEST_CASE("a ball that rolls from solid tiles onto a hazard is told of the hazard when it comes to it",
          "[dynamics][tiles]") {
    const TileMap map = tileMapOf({"..........", "####^^####"});
    World world;
    const BodyId ground = world.add({.type = BodyType::Static, .shapes = {tiles(map)}});
    const BodyId ball = world.add({.position = {2.5, 1.25}, .velocity = {3, 0}, .shapes = {circle(0.25)}});
    std::optional<double> first;
    bool also = true;
    for (int tick = 0; tick < 60; ++tick) {
        world.step(dt);
        const double x = world.body(ball).position().x();
        for (const auto& e : world.contactBegins())
            if (e.tile && map.at(*e.tile).kind == TileKind::Hazard && !first) first = x;
        if (x < 4.1 || x > 5.9) continue;
        const auto contacts = world.body(ball).contacts();
        also = also && std::any_of(contacts.begin(), contacts.end(), [&](const Contact& contact) {
                   return map.at(contact.points.at(0).tile.value()).kind == TileKind::Hazard;
               });
    }
    REQUIRE(first);
    CHECK(*first == Approx(4).margin(0.11));  // two ticks of 5 cm
    CHECK(also);
    CHECK(world.contains(ground));
}
