// SPDX-License-Identifier: MIT
// What do one-way tiles do to bodies beside what is solid, and alone in the air?
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <plumb/math/random.h>
#include <plumb/movers/move_and_slide.h>
#include <plumb/plumb.h>
#include <plumb/shapes/tile_text.h>
#include "cases.h"
#include "catch.h"
#include "kit/dynamics/sliders.h"
#include "kit/usual_world.h"

using namespace plumb;
using namespace plumb::test;

namespace {

Slider sliderWithFriction(Slider slider, double friction) {
    slider.shape.material.friction = friction;
    return slider;
}

ShapeDef mapOf(const std::vector<std::string>& rows, double friction) {
    return plumb::tiles(tileMapOf(rows), {.friction = friction});
}

struct Step {
    Vec2 position, velocity;
};

/// Of each step, the body's place and velocity in a world with some grounds.
std::vector<Step> pathOf(const BodyDef& body, const std::vector<BodyDef>& grounds, int ticks, double gravity = 9.81) {
    World world({.gravity = {0, -gravity}, .sleeping = false});
    for (const BodyDef& ground : grounds) world.add(ground);
    const BodyId id = world.add(body);
    std::vector<Step> path;
    for (int tick = 0; tick < ticks; ++tick) {
        world.step(dt);
        path.push_back({world.body(id).position(), world.body(id).velocity()});
    }
    return path;
}

BodyDef fixed(const ShapeDef& shape, const Vec2& at = {0, 0}) {
    return {.type = BodyType::Static, .position = at, .shapes = {shape}};
}

/// Two runs along a floor at a height of 2 m, of tiles and of one slab, until the first comes near the floor's end.
void requireLikeSlab(const std::vector<std::string>& rows, const Slider& slider, double friction, double speed) {
    const double width = static_cast<double>(rows[0].size()), forward = speed > 0 ? 1 : -1;
    const BodyDef body{.position = {forward > 0 ? 1.0 : width - 1, 2 + slider.below},
                       .velocity = {speed, 0},
                       .shapes = {sliderWithFriction(slider, friction).shape}};
    const int ticks = std::min(240, static_cast<int>((width - 2) / std::fabs(speed) / dt));
    const std::vector<Step> tiled = pathOf(body, {fixed(mapOf(rows, friction))}, ticks);
    const std::vector<Step> whole =
        pathOf(body, {fixed(plumb::box({width / 2, 1}, {.friction = friction}), {width / 2, 1})}, ticks);
    for (std::size_t i = 0; i < tiled.size(); ++i) {
        // With friction: what comes to rest, on the slab too, rocks back at up to 5 mm/s in that step.
        const double way = (whole[i].position - body.position).norm();
        REQUIRE((tiled[i].position - whole[i].position).norm() < 1e-3 + 1e-4 * way);
        REQUIRE((tiled[i].velocity - whole[i].velocity).norm() < std::max(5e-3, 1e-3 * std::fabs(speed)));
        if (friction > 0) continue;
        // Rounded to the solver's floats once, and never again.
        REQUIRE(forward * tiled[i].velocity.x() >= std::fabs(speed) * (1 - 0x1p-24));
    }
}

}  // namespace

TEST_CASE("a box at 7 m/s does not hop where a one-way top ends flush at a solid tile, nor does any shape, both ways",
          "[dynamics][tiles]") {
    const std::vector<std::string> left{"====####", "########"}, right{"####====", "########"},
        gap{"==##==##", "..##..##"};
    for (const std::vector<std::string>& rows : {left, right, gap}) {
        for (int kind = 0; kind < 4; ++kind) {
            for (const double speed : {1.0, 3.0, 7.0, 15.0, -1.0, -3.0, -7.0, -15.0}) {
                for (const double friction : {0.0, 0.3}) {
                    const Slider slider = sliderOf(kind, 0.4);
                    INFO(rows[0] << ": " << slider.name << " at " << speed << " m/s, friction " << friction);
                    requireLikeSlab(rows, slider, friction, speed);
                }
            }
        }
    }
}

TEST_CASE("2,000 bodies slide over random rows of one-way and solid tiles as over a slab", "[dynamics][tiles]") {
    for (int seed = 0; seed < cases(2000); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        std::vector<std::string> rows(2);
        for (int column = 0; column < 40; ++column) {
            rows[0] += random.integer(0, 1) == 0 ? '=' : '#';
            rows[1] += ".=#"[random.integer(0, 2)];
        }
        const Slider slider = sliderOf(random.integer(0, 3), random.uniform(0.1, 0.9));
        const double friction = random.integer(0, 1) == 0 ? 0 : random.uniform(0.05, 0.4);
        const double speed = (random.integer(0, 1) == 0 ? 1 : -1) * std::pow(10, random.uniform(-0.5, 1.5));
        INFO("seed " << seed << ": " << slider.name << " at " << speed << " m/s, friction " << friction << " over "
                     << rows[0]);
        requireLikeSlab(rows, slider, friction, speed);
    }
}

namespace {

/// Before a wall 4 m to the right, in a row of one-way tiles or in none.
struct Entrance {
    Slider slider;
    double feet = 0;  ///< below the tiles' top [m]
    double away = 0;  ///< from its outermost point to the wall [m]
    Vec2 velocity{0, 0};
    bool mirrored = false;
};

std::vector<Step> enter(const Entrance& e, char tile, int ticks) {
    std::vector<std::string> rows{std::string(4, tile) + "####", "########"};
    const double f = e.mirrored ? -1 : 1;
    if (e.mirrored)
        for (std::string& row : rows) std::reverse(row.begin(), row.end());
    const Aabb box = aabbOf(e.slider.shape.shape, {});
    const double x = 4 - e.away - box.upper.x();
    const BodyDef body{.position = {e.mirrored ? 8 - x : x, 2 - e.feet + e.slider.below},
                       .velocity = {f * e.velocity.x(), e.velocity.y()},
                       .fixedRotation = true,
                       .shapes = {e.slider.shape}};
    std::vector<Step> path = pathOf(body, {fixed(mapOf(rows, 0))}, ticks);
    for (Step& step : path) {
        if (e.mirrored) step.position.x() = 8 - step.position.x();
        step.velocity.x() *= f;
    }
    return path;
}

/// Until its feet, or its widest part, come up to the tiles' top, it goes as if there were none: the wall's corner, met
/// by a body's tip, may be met or not by roundings. Gives whether the wall stopped it.
bool requireAsWithout(const Entrance& e, int ticks) {
    const std::vector<Step> through = enter(e, '=', ticks), without = enter(e, '.', ticks);
    for (std::size_t i = 0; i < through.size(); ++i) {
        const double middle = without[i].position.y();
        if (middle - e.slider.below > 2 - 0.03 || std::fabs(middle - 2) < 0.1) return false;
        // Of a disc that bounces off the corner by its depth in it, at 20 m/s.
        REQUIRE((through[i].position - without[i].position).norm() < 2e-3);
    }
    return through.back().velocity.x() < 1e-3;
}

}  // namespace

TEST_CASE("2,000 bodies of 10 cm to 3 m that walk within one-way tiles meet the wall behind as without the tiles",
          "[dynamics][tiles]") {
    int stopped = 0;
    for (int seed = 0; seed < cases(2000); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Slider slider = sliderWithFriction(sliderOf(random.integer(0, 3), random.uniform(0.05, 1.5)), 0);
        const Entrance e{slider, 1, random.uniform(0.01, 1), {random.uniform(0.1, 20), 0}, random.integer(0, 1) == 0};
        INFO("seed " << seed << ": " << slider.name << " " << slider.below << " m at " << e.velocity.x() << " m/s");
        stopped += requireAsWithout(e, 120) ? 1 : 0;
    }
    CHECK(stopped > cases(2000) / 5);
}

TEST_CASE("2,000 bodies that come up through one-way tiles, or fall back, meet the wall beside as without the tiles",
          "[dynamics][tiles]") {
    int stopped = 0;
    for (int seed = 0; seed < cases(2000); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Slider slider = sliderWithFriction(sliderOf(random.integer(0, 3), random.uniform(0.05, 1)), 0);
        const Entrance e{slider,
                         random.uniform(0.05, 0.95),
                         random.uniform(0, 0.3),
                         {random.uniform(0, 10), random.uniform(-3, 4)},
                         random.integer(0, 1) == 0};
        INFO("seed " << seed << ": " << slider.name << " " << slider.below << " m, feet " << e.feet << " below, at "
                     << e.velocity.transpose() << " m/s");
        stopped += requireAsWithout(e, 60) ? 1 : 0;
    }
    CHECK(stopped > cases(2000) / 5);
}

TEST_CASE("2,000 bodies that come to a lone one-way tile from below or from the side fly on as if there were none",
          "[dynamics][tiles]") {
    for (int seed = 0; seed < cases(2000); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Slider slider = sliderOf(random.integer(0, 3), random.uniform(0.1, 0.9));
        // The tile's top lies at 0 <= x <= 1, y = 0. From below, or from the side with the feet deeper than 5 mm.
        const bool rises = random.integer(0, 1) == 0;
        const double f = random.integer(0, 1) == 0 ? 1 : -1;
        const double feet = rises ? random.uniform(0.05, 2) : random.uniform(0.01, 2 * slider.below);
        const Vec2 velocity = rises ? Vec2(random.uniform(-3, 3), random.uniform(3, 20))
                                    : Vec2(-f * random.uniform(1, 20), random.uniform(-0.5, 0));
        const double x = rises ? random.uniform(-1, 2) : 0.5 + f * (0.6 + 2.5 * slider.below);
        const BodyDef body{.position = {x, slider.below - feet}, .velocity = velocity, .shapes = {slider.shape}};
        const double gravity = rises || random.integer(0, 1) == 0 ? 9.81 : 0;
        INFO("seed " << seed << ": " << slider.name << " " << slider.below << " m, feet " << feet << " below, at "
                     << velocity.transpose() << " m/s");
        const std::vector<Step> path = pathOf(body, {fixed(plumb::tiles(tileMapOf({"="})), {0, -1})}, 60, gravity);
        const std::vector<Step> free = pathOf(body, {}, 60, gravity);
        for (std::size_t i = 0; i < path.size(); ++i) {
            // What comes down, and steeper than by 45 degrees, may land.
            if (-free[i].velocity.y() > (rises ? 0 : std::fabs(velocity.x()))) break;
            REQUIRE((path[i].position - free[i].position).norm() < 1e-9);
        }
    }
}

TEST_CASE(
    "1,000 crates that fall on the ends of one-way tiles, turned by up to 20 degrees, tip or rest as on a solid line",
    "[dynamics][tiles]") {
    int held = 0;
    for (int seed = 0; seed < cases(1000); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const double x = random.integer(0, 1) == 0 ? random.uniform(-0.2, 0.5) : random.uniform(2.5, 3.2);
        const BodyDef crate{.position = {x, random.uniform(0.7, 2)},
                            .angle = random.uniform(-0.35, 0.35),
                            .velocity = {0, -random.uniform(0, 10)},
                            .shapes = {plumb::box({0.4, 0.4}, {.friction = 1})}};
        const Material rough{.friction = 1};
        const BodyDef tiles = fixed(plumb::tiles(tileMapOf({"==="}), rough), {0, -1});
        const std::vector<Step> onTiles = pathOf(crate, {tiles}, 120);
        const std::vector<Step> onLine = pathOf(crate, {fixed(segment({3, 1}, {0, 1}, rough), {0, -1})}, 120);
        INFO("seed " << seed << ": at " << x << " m, turned by " << crate.angle << ", at " << crate.velocity.y());
        // After some bounces they are mm apart, but rest or fall alike.
        CHECK((onTiles.back().position.y() > 0.39) == (onLine.back().position.y() > 0.39));
        held += onTiles.back().position.y() > 0.39 ? 1 : 0;
    }
    CHECK(held > cases(1000) / 4);
}

TEST_CASE("a mover at 3 to 25 m/s walks over rows of one-way and solid tiles at its speed, always on the floor",
          "[movers][tiles]") {
    for (int seed = 0; seed < cases(300); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        std::string row;
        for (int column = 0; column < 60; ++column) row += random.integer(0, 1) == 0 ? '=' : '#';
        World world({.gravity = {0, 0}});
        world.add(fixed(plumb::tiles(tileMapOf({row}))));
        const Slider slider = sliderOf(random.integer(0, 3), random.uniform(0.1, 0.9));
        const double speed = random.uniform(3, 25);
        const BodyId hero =
            world.add({.type = BodyType::Kinematic, .position = {2, 1.01 + slider.below}, .shapes = {slider.shape}});
        INFO("seed " << seed << ": " << slider.name << " at " << speed << " m/s over " << row);
        Slide slide;
        for (int tick = 0; tick < 120; ++tick) {
            slide = moveAndSlide(world, hero, {.velocity = {speed, -5}, .dt = dt}, {}, slide);
            world.step(dt);
            REQUIRE((tick < 2 || slide.isOnFloor));
        }
        CHECK(world.body(hero).position().x() == Approx(2 + 120 * dt * speed).margin(1e-9));
    }
}
