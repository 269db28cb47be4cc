// SPDX-License-Identifier: MIT
#include <cmath>

#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>
#include <plumb/shapes/tile_text.h>

namespace plumb::compare {
namespace {

constexpr double skin = 1e-3;  // the distance that movers keep from what they meet [m]

SceneBody solid(const char* name, const Vec2& center, const Vec2& halfSize) {
    return {name, {.type = BodyType::Static, .position = center, .shapes = {box(halfSize)}}};
}

SceneBody moved(const char* name, const Vec2& position, const ShapeDef& shape) {
    return {name, {.type = BodyType::Kinematic, .position = position, .shapes = {shape}}};
}

/// A list of flights, each of which starts where the last one ended.
class Legs {
public:
    explicit Legs(const Vec2& start) : end_(start) {}

    Legs& go(double time, const Vec2& velocity, const Vec2& acceleration = {0, 0}) {
        flights_.push_back({.start = time_, .position = end_, .velocity = velocity, .acceleration = acceleration});
        end_ += velocity * time + acceleration * (time * time / 2);
        time_ += time;
        return *this;
    }
    std::vector<Flight> rest() { return go(0, {0, 0}).flights_; }
    std::vector<Flight> flights() const { return flights_; }

private:
    Vec2 end_;
    double time_ = 0;
    std::vector<Flight> flights_;
};

/// The hero stands for takeOff before it jumps [s].
Scene jump(const char* name, PlatformStyle profile, double takeOff) {
    const Vec2 half(0.4, 0.5);
    return {
        .name = name,
        .bodies = {solid("floor", {0, -0.5}, {5, 0.5}), moved("hero", {0, half.y() + skin}, box(half))},
        .movers = {{.name = "player",
                    .body = "hero",
                    .motion = PlatformMotion{profile, {{.time = takeOff, .jump = true}}}}},
    };
}

}  // namespace

Scene moverWall() {
    const double speed = 3, way = 4.5 - skin;
    return {
        .name = "mover_wall",
        .question = "Is a body that a game moves stopped by a wall?",
        .duration = 3,
        .bodies = {solid("wall", {5.1, 0}, {0.1, 2}), moved("hero", {0, 0}, box({0.5, 0.5}))},
        .movers = {{.name = "player", .body = "hero", .motion = SlidingMotion{{speed, 0}}}},
        .closedForm = ClosedForm{.formula = "x = v t, up to a skin of 1 mm before the wall",
                                 .source = "Phaser, Godot and their like: what users of Box2D ask for",
                                 .bodies = {PiecewiseMotion{"hero", Legs({0, 0}).go(way / speed, {speed, 0}).rest()}}},
        .checks = {ExactCheck{1e-9, "found by a cast in double precision, which is exact to about 1e-10 m"}},
    };
}

Scene platformRide() {
    return {
        .name = "platform_ride",
        .question = "Does what stands on a platform that runs to and fro stay where it stands?",
        .duration = 30,
        .bodies = {moved("platform", {0, -0.25}, box({1.5, 0.25})), moved("rider", {0.5, 0.5 + skin}, box({0.3, 0.5}))},
        .movers = {{.name = "drive",
                    .body = "platform",
                    .motion = PathMotion{.points = {{0, -0.25}, {8, 1.75}},
                                         .delay = 0.5,
                                         .speed = 4,
                                         .easing = Easing::SmoothStep,
                                         .repeat = PathRepeat::BackAndForth}},
                   {.name = "player", .body = "rider", .motion = PlatformMotion{}}},
        .probes = {{.name = "slip", .quantity = ApartProbe{"platform", "rider", {1, 0}}, .expected = 0.5, .unit = "m"}},
        .checks = {invariant("probe.slip", 1e-9, "its place is kept in the platform's own frame")},
    };
}

Scene mazeLap() {
    const double speed = 5;
    const int laps = 10;
    Legs legs(Vec2(2.5, 1.5));
    legs.go(3 / speed, {speed, 0});
    for (int lap = 0; lap < laps; ++lap)
        legs.go(2 / speed, {0, speed}).go(4 / speed, {-speed, 0}).go(2 / speed, {0, -speed}).go(4 / speed, {speed, 0});
    return {
        .name = "maze_lap",
        .question = "Is a mover that goes round a maze ten times still on its lane?",
        .duration = 24,
        .bodies = {{"maze",
                    {.type = BodyType::Static,
                     .shapes = {tiles(tileMapOf({"#######", "#.....#", "#.###.#", "#.....#", "#######"}))}}},
                   moved("runner", {2.5, 1.5}, circle(0.4))},
        .movers = {{.name = "player",
                    .body = "runner",
                    .motion =
                        GridMotion{.map = "maze",
                                   .cell = {2, 1},
                                   .speed = speed,
                                   .turns = {Direction::Up, Direction::Left, Direction::Down, Direction::Right}}}},
        .closedForm = ClosedForm{.formula = "12 tiles a lap, at 5 tiles a second; turns take no time",
                                 .source = "the lanes go through the middles of the tiles",
                                 .bodies = {PiecewiseMotion{"runner", legs.flights()}}},
        .checks = {ExactCheck{
            1e-9, "a place is stored as a tile and the way from its middle: only one tick's rounding is left"}},
    };
}

Scene jump1985() {
    // 16 pixels are a metre. The speed is 4 pixels a tick up, less 32/256 a tick while rising, 112/256 while falling.
    // First the place changes, then the speed: in n ticks v n - a n (n - 1) / 2, which is a parabola with the speed
    // v + a / 2.
    const double rate = 60.0988, pixel = 1.0 / 16, rise = 0.125 * pixel, fall = 0.4375 * pixel, speed = 4 * pixel;
    Scene scene = jump("jump_1985", PlatformStyle::Of1985, 6 / rate);
    scene.question = "Does a jump of 1985 rise 66 pixels in 32 ticks, and fall as its tables have it?";
    scene.dt = 1 / rate;
    scene.duration = 47 / rate;
    const Vec2 start = scene.bodies[1].def.position;
    scene.closedForm = ClosedForm{
        .formula = "in n ticks v n - a n (n - 1) / 2; v 4, a 32/256 rising, 112/256 falling [pixels]",
        .source = "public disassemblies of the platform game of 1985",
        .bodies = {PiecewiseMotion{"hero", Legs(start)
                                               .go(6 / rate, {0, 0})
                                               .go(32 / rate, {0, (speed + rise / 2) * rate}, {0, -rise * rate * rate})
                                               .go(9 / rate, {0, fall / 2 * rate}, {0, -fall * rate * rate})
                                               .flights()}}};
    scene.checks = {ExactCheck{1e-9, "whole multiples of 1/4096 pixel a tick are exact"}};
    return scene;
}

Scene jumpModern() {
    // It rises 2.5 m in 0.4 s, with half of the gravity during the last tenth of the speed:
    // 0.9 v / g + 0.2 v / g = 0.4 s and (1 - 0.01) v^2 / 2 g + 0.01 v^2 / g = 2.5 m, so v / g = 4 / 11 s and
    // v^2 / g = 5 / 1.01 m. On the way down, the gravity is 1.6 g, and half of that until the speed is a tenth of v. By
    // hand:
    const double speed = 1375.0 / 101, g = 15125.0 / 404, slow = 137.5 / 101, down = 6050.0 / 101;
    const double riseTime = 18.0 / 55, hangRise = 4.0 / 55, hangFall = 1.0 / 22;
    const double fallTime = (std::sqrt(3036343.75) - 137.5) / 6050;  // over a height of 249.375 / 101 m
    Scene scene = jump("jump_modern", PlatformStyle::Modern, 0.1);
    scene.question = "Is a jump with a hang near its top 2.5 m high, and as long as its formula says?";
    scene.duration = 1;
    const Vec2 start = scene.bodies[1].def.position;
    scene.closedForm =
        ClosedForm{.formula = "v = 1375/101 m/s, g = 15125/404 m/s^2; in four stretches: g, g / 2; 0.8 g, 1.6 g",
                   .source = "textbook: two equations, of the height and of the time, solved by hand",
                   .bodies = {PiecewiseMotion{"hero", Legs(start)
                                                          .go(0.1, {0, 0})
                                                          .go(riseTime, {0, speed}, {0, -g})
                                                          .go(hangRise, {0, slow}, {0, -0.5 * g})
                                                          .go(hangFall, {0, 0}, {0, -0.5 * down})
                                                          .go(fallTime, {0, -slow}, {0, -down})
                                                          .rest()}}};
    scene.checks = {ExactCheck{1e-9, "exactly these parabolas, at any length of tick"}};
    return scene;
}

}  // namespace plumb::compare
