// SPDX-License-Identifier: MIT
// A tile that fills the top of its cell only leaves a hollow below, narrower than a quarter turn, in what is flush
// above.
#include <algorithm>
#include <cmath>
#include <vector>

#include <plumb/movers/move_and_slide.h>
#include <plumb/plumb.h>
#include "cases.h"
#include "catch.h"
#include "kit/dynamics/sliders.h"
#include "kit/usual_world.h"

using namespace plumb;
using namespace plumb::test;

namespace {

constexpr double speed = 3;

/// A row of full tiles but for one; empty unless that one's top goes from side to side.
std::optional<TileMap> rowWith(TileForm form, bool hanging, double size) {
    TileMap map({.columns = 12, .rows = 2, .size = size});
    for (int i = 0; i < 12; ++i) map.set({i, 0}, {.form = TileForm::Full});
    map.set({6, 0}, {.form = form, .upsideDown = hanging});
    const std::vector<Vec2> corners = map.cornersOf({6, 0});
    const auto isTop = [size](const Vec2& corner) { return corner.y() == size; };
    return std::count_if(corners.begin(), corners.end(), isTop) == 2 ? std::optional(map) : std::nullopt;
}

struct TipSlider {
    ShapeDef shape;
    double below;  ///< from its origin to what it slides on [m]
};
std::vector<TipSlider> tipSliders(double s) {
    return {{box({0.4 * s, 0.4 * s}, smooth), 0.4 * s},
            {capsule({-0.3 * s, 0}, {0.3 * s, 0}, 0.4 * s, smooth), 0.4 * s},
            {circle(0.45 * s, smooth), 0.45 * s},
            {roundedBox({0.3 * s, 0.35 * s}, 0.1 * s, smooth), 0.45 * s}};
}

/// Both ways over the odd tile, for every form and size: run(map, slider, start, way).
void forAllRows(const auto& run) {
    const int sizes = cases(40);
    int rows = 0;
    for (int form = 1; form <= static_cast<int>(TileForm::GentleDownLow); ++form) {
        for (const bool hanging : {false, true}) {
            for (int n = 0; n < sizes; ++n) {
                const double size = 0.5 + 1.0 / sizes * n;
                const auto map = rowWith(static_cast<TileForm>(form), hanging, size);
                if (!map) continue;
                ++rows;
                for (const TipSlider& slider : tipSliders(size))
                    for (const double way : {-1.0, 1.0})
                        run(*map, slider, Vec2((6 - 4 * way) * size, size + slider.below), way);
            }
        }
    }
    CHECK(rows == sizes * 8);  // full, upright and hanging, and the six hanging slopes
}

}  // namespace

TEST_CASE("2,560 smooth bodies slide over a slope that hangs in a floor as over a full tile, and lose nothing",
          "[dynamics][tiles]") {
    forAllRows([](const TileMap& map, const TipSlider& slider, const Vec2& start, double way) {
        World world;
        world.add({.type = BodyType::Static, .shapes = {tiles(map, smooth)}});
        const BodyId body = world.add({.position = start, .velocity = {way * speed, 0}, .shapes = {slider.shape}});
        const int ticks = static_cast<int>(7 * map.size() / (speed * dt));
        for (int tick = 0; tick < ticks; ++tick) world.step(dt);
        INFO("form " << static_cast<int>(map.at({6, 0}).form) << ", size " << map.size() << ", way " << way);
        // 4 roundings to float a tick, of 3 m/s each: 168 * 4 * 2^-24 * 3.
        CHECK(std::fabs(world.body(body).velocity().x() - way * speed) < 1.3e-4);
    });
}

TEST_CASE("2,560 movers slide over a slope that hangs in a floor as over a full tile, and lose nothing",
          "[movers][tiles]") {
    forAllRows([](const TileMap& map, const TipSlider& slider, const Vec2& start, double way) {
        World world;
        world.add({.type = BodyType::Static, .shapes = {tiles(map)}});
        const BodyId body =
            world.add({.type = BodyType::Kinematic, .position = start + Vec2(0, 1e-3), .shapes = {slider.shape}});
        const int ticks = static_cast<int>(7 * map.size() / (speed * dt));
        Slide slide;
        for (int tick = 0; tick < ticks; ++tick) {
            slide = moveAndSlide(world, body, {.velocity = {way * speed, -1}, .dt = dt}, {}, slide);
            world.step(dt);
        }
        INFO("form " << static_cast<int>(map.at({6, 0}).form) << ", size " << map.size() << ", way " << way);
        CHECK(std::fabs((world.body(body).position() - start).x() - way * speed * dt * ticks) < 1e-9);
    });
}

TEST_CASE("a mover goes up and down a wall in which a slope's back is flush, and is not stopped at its tip",
          "[movers][tiles]") {
    // The wall's right side is flush; the slope fills its cell from there, and leaves a hollow within the wall.
    for (const TileForm form : {TileForm::SlopeUp, TileForm::GentleUpHigh}) {
        for (const bool hanging : {false, true}) {
            TileMap map({.columns = 1, .rows = 12});
            for (int i = 0; i < 12; ++i) map.set({0, i}, {.form = TileForm::Full});
            map.set({0, 6}, {.form = form, .upsideDown = hanging});
            for (const TipSlider& slider : tipSliders(1)) {
                for (const double way : {-1.0, 1.0}) {
                    World world;
                    world.add({.type = BodyType::Static, .shapes = {tiles(map)}});
                    const Vec2 start(1.6, 6.5 - 3.5 * way);
                    const BodyId body =
                        world.add({.type = BodyType::Kinematic, .position = start, .shapes = {slider.shape}});
                    Slide slide;
                    for (int tick = 0; tick < 120; ++tick) {
                        slide = moveAndSlide(world, body, {.velocity = {-2, way * speed}, .dt = dt}, {}, slide);
                        world.step(dt);
                    }
                    CHECK(std::fabs((world.body(body).position() - start).y() - way * speed * 2) < 1e-9);
                }
            }
        }
    }
}
