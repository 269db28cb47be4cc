// SPDX-License-Identifier: MIT
#include <compare/scene/bench/scenes.h>
#include <plumb/math/random.h>

namespace plumb::compare {
namespace {

constexpr int count = 1000;
constexpr Tile wallTile{.form = TileForm::Full};

ShapeDef amongNoneOfItsKind(ShapeDef shape) {
    shape.filter.group = -1;
    return shape;
}

SceneBody mapBody(const TileMap& map) {
    return {"map", {.type = BodyType::Static, .shapes = {tiles(map)}}};
}

void add(Scene& scene, int number, const Vec2& position, const ShapeDef& shape, const MoverMotion& motion) {
    const std::string name = "mover_" + std::to_string(number + 1);
    scene.bodies.push_back(
        {name, {.type = BodyType::Kinematic, .position = position, .shapes = {amongNoneOfItsKind(shape)}}});
    scene.movers.push_back({name, name, motion});
}

}  // namespace

/// A map that wraps, with pillars in every other cell of both axes. Each mover has its own list of turns.
Scene gridMovers() {
    Scene scene{.name = "grid_movers",
                .question = "1,000 movers in a maze of 100 by 100 tiles",
                .gravity = {0, 0},
                .duration = 10,
                .wrap = {.width = 100, .height = 100}};
    TileMap map({.columns = 100, .rows = 100, .wrapX = true, .wrapY = true});
    for (int row = 1; row < 100; row += 2)
        for (int column = 1; column < 100; column += 2) map.set({column, row}, wallTile);
    scene.bodies.push_back(mapBody(map));
    Random random(1);
    for (int i = 0; i < count; ++i) {
        GridMotion motion{.map = "map", .cell = {2 * random.integer(0, 49), 2 * random.integer(0, 49)}, .speed = 9.5};
        motion.heading = static_cast<Direction>(random.integer(0, 3));
        for (int turn = 0; turn < 8; ++turn) motion.turns.push_back(static_cast<Direction>(random.integer(0, 3)));
        add(scene, i, map.centerOf(motion.cell), circle(0.4), motion);
    }
    return scene;
}

/// A ground of 2,000 tiles with steps, and ledges above it. Each mover runs to and fro and jumps at its own rhythm.
Scene platformMovers() {
    Scene scene{.name = "platform_movers",
                .question = "1,000 movers that run and jump on 2,000 tiles of ground",
                .duration = 10};
    TileMap map({.columns = 2000, .rows = 8});
    for (int column = 0; column < 2000; ++column) {
        map.set({column, 0}, wallTile);
        if (column % 16 < 4) map.set({column, 1}, wallTile);
        if (column % 16 >= 8 && column % 16 < 12) map.set({column, 3}, {TileForm::Full, TileKind::OneWay});
    }
    scene.bodies.push_back(mapBody(map));
    for (int i = 0; i < count; ++i) {
        PlatformMotion motion;
        for (int beat = 0; beat < 15; ++beat)
            motion.cues.push_back(
                {.time = 0.7 * beat, .move = (beat + i) % 2 == 0 ? 1.0 : -1.0, .jump = (beat + i) % 3 == 0});
        add(scene, i, {1.0 + 1.998 * i, 2.6}, box({0.3, 0.55}), motion);
    }
    return scene;
}

}  // namespace plumb::compare
