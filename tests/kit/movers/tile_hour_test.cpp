// SPDX-License-Identifier: MIT
// An hour of random play over tiles that change.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

#include "cases.h"
#include "catch.h"
#include "kit/movers/stage.h"
#include "kit/movers/tile_levels.h"

namespace plumb::test {

namespace {

constexpr int levelColumns = 40, levelRows = 24;

/// Every other one goes on at its other side.
struct TileLevel {
    Random random;
    double size;
    bool wraps;
    BruteTiles truth;
    World world;
    ShapeId tiles;

    explicit TileLevel(std::uint64_t seed)
        : random(seed),
          size(random.uniform(0.5, 1.5)),
          wraps(random.integer(0, 1) == 1),
          world(wraps ? WorldDef{.wrap = {.width = levelColumns * size}} : WorldDef{}) {
        truth.map = tileMapOf(tileLevelText(random, levelColumns, levelRows, !wraps), size);
        const BodyId ground = world.add({.type = BodyType::Static, .shapes = {plumb::tiles(truth.map)}});
        tiles = world.body(ground).shapes()[0];
        truth.map = truth.map.wrapping(wraps, false);
    }

    Vec2 freePlace(const Shape& hero) {
        for (;;) {
            const Vec2 at = size * Vec2(random.uniform(2, levelColumns - 2), random.uniform(2, levelRows - 2));
            if (truth.isFree(hero, at)) return at;
        }
    }

    /// Any tile of the legend, within three of the hero, or anywhere but in the border; not where the hero is, or its
    /// skin.
    void edit(const Shape& hero, const Vec2& at) {
        const Cell here = truth.map.cellAt(at);
        Cell cell{random.integer(0, levelColumns - 1), random.integer(0, levelRows - 1)};
        if (random.integer(0, 1) == 0) cell = {here.column + random.integer(-3, 3), here.row + random.integer(-3, 3)};
        if (cell.row < 1 || cell.row > levelRows - 2 || (!wraps && (cell.column < 1 || cell.column > levelColumns - 2)))
            return;
        cell = truth.map.wrapped(cell);
        const Aabb mine = inflate(aabbOf(hero, {at, {}}), 1e-3);
        for (const double round : {-levelColumns * size, 0.0, levelColumns * size}) {
            const Vec2 low = truth.map.lowerLeft(cell) + Vec2(wraps ? round : 0, 0);
            if (overlap(mine, Aabb{low, low + Vec2(size, size)})) return;
        }
        Tile tile = standardLegend().at("....####==^~/\\1234"[random.integer(0, 17)]);
        tile.upsideDown = tile.kind == TileKind::Solid && random.integer(0, 3) == 0;
        truth.map.set(cell, tile);
        world.setTile(tiles, cell, tile);
    }
};

std::vector<ShapeDef> tileHeroes(double size) {
    return {box({0.4 * size, 0.9 * size}), capsule({0, -0.5 * size}, {0, 0.5 * size}, 0.4 * size), circle(0.45 * size),
            roundedBox({0.3 * size, 0.35 * size}, 0.1 * size)};
}

/// Held for random times.
void press(PlatformInput& input, Random& random) {
    if (random.integer(0, 14) == 0) input.move = random.integer(-2, 2) / 2.0;
    if (random.integer(0, 9) == 0) input.jump = !input.jump;
    if (random.integer(0, 29) == 0) input.run = !input.run;
    input.down = random.integer(0, 19) == 0;
}

/// A little less than a skin around it.
Shape withSkin(Shape shape) {
    std::visit(
        [](auto& s) {
            if constexpr (requires { s.radius; }) s.radius += 0.95e-3;
        },
        shape);
    return shape;
}

/// Could it go 5 cm on, on the level or up a slope of at most 45 degrees?
bool isWayOpen(const BruteTiles& truth, const Shape& hero, const Vec2& at, double side) {
    for (const double rise : {0.0, 0.025, 0.05})
        if (truth.isFree(withSkin(hero), at, {0.05 * side, rise})) return true;
    return false;
}

/// One level's half minute.
struct Play {
    TileLevel level;
    ShapeDef hero;
    PlatformMover mover;
    PlatformInput input = {};
    bool modern;
    bool wasDown = false;
    int moves = 0;

    explicit Play(int n)
        : level(5000 + static_cast<std::uint64_t>(n)),
          hero(tileHeroes(level.size)[static_cast<std::size_t>(n) % 4]),
          mover(addKinematic(level.world, level.freePlace(hero.shape), hero), n % 3 ? modernProfile() : profile1985()),
          modern(n % 3 != 0) {}

    Vec2 place() const { return level.world.body(mover.body()).position(); }

    /// What went wrong in a tick; nothing if all went well.
    std::string tick() {
        press(input, level.random);
        if (level.random.integer(0, 11) == 0) level.edit(hero.shape, place());
        // Now and then a blow, of up to 3 m a tick.
        if (level.random.integer(0, 199) == 0)
            mover.setVelocity({level.random.uniform(-180, 180), level.random.uniform(-180, 180)});
        const Vec2 before = place();
        const double side = input.move > 0 ? 1 : -1, speed = mover.slide().velocity.x();
        const bool open = isWayOpen(level.truth, hero.shape, before, side), stood = mover.slide().isOnFloor;
        const bool dropped = !mover.slide().dropping.empty() || input.down || wasDown;
        wasDown = input.down;
        const Slide& slide = mover.step(level.world, input, dt);
        level.world.step(dt);
        const Vec2 way = level.world.wrap().shortest(before, place()), now = before + way;
        if (!now.allFinite() || !slide.velocity.allFinite()) return "not a number";
        const double depth = level.truth.depth(hero.shape, now);
        // 1e-9 m: 40 tiles of 1.5 m, and a round, to 2^-53.
        if (depth > 1e-9) return "in a wall by " + std::to_string(depth) + " m";
        if (!level.truth.isWay(level.truth.map.cellAt(before), level.truth.map.cellAt(now))) return "through a wall";
        if (!dropped && slide.dropping.empty() && level.truth.sunkInto(hero.shape, before, now))
            return "sunk into a one-way tile";
        if (slide.crushed) return "crushed, where nothing moves";
        if (!modern || input.move == 0 || !stood || !slide.isOnFloor || !open || speed * side < 0 || dropped) return "";
        // The truth knows of no one-way tiles: on the corner of one it may be in the way of itself.
        if (slide.floor->oneWay && slide.floorNormal != Vec2(0, 1)) return "";
        ++moves;
        // On the floor it goes where it is told, at the lesser of its speeds, on a slope of at most 45 degrees; over an
        // edge at least to where it comes down.
        const bool follows = way.y() >= -1.01 * std::fabs(way.x());
        const double least = follows ? 0.7 * dt * std::min({std::fabs(speed), std::fabs(slide.velocity.x()), 2.0}) : 0;
        const double went = way.x() * side;
        return went > 0 && went >= least ? "" : "stuck, " + std::to_string(went);
    }
};

}  // namespace

TEST_CASE("in an hour of random play over tiles that change a mover is never in a wall, and goes where a way is open",
          "[movers][tiles]") {
    const int levels = std::max(4, cases(120)), ticks = 30 * 60;
    int moves = 0;
    for (int n = 0; n < levels; ++n) {
        Play play(n);
        for (int tick = 0; tick < ticks; ++tick) {
            const std::string wrong = play.tick();
            if (!wrong.empty()) {
                FAIL_CHECK("level " << n << ", tick " << tick << ", at " << play.place().transpose() << ": " << wrong);
                break;
            }
        }
        moves += play.moves;
    }
    CHECK(moves > 100 * levels);
}

}  // namespace plumb::test
