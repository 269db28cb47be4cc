// SPDX-License-Identifier: MIT
// Floors of several shapes that are laid flush, each a body of its own.
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <plumb/plumb.h>
#include "cases.h"
#include "catch.h"
#include "kit/usual_world.h"
#include "numbers.h"

using namespace plumb;
using namespace plumb::test;

namespace {

/// What slides, on which floor, drawn from a seed.
struct Slide {
    double angle, size, radius, friction, restitution, speed, start, gap;  ///< size: half of a box of the floor
    int kind;

    explicit Slide(unsigned seed) {
        std::mt19937 random(seed);
        const auto share = [&] { return std::uniform_real_distribution<double>(0, 1)(random); };
        angle = 2 * pi * share();
        size = 0.1 + 0.9 * share();
        radius = 0.1 + 0.9 * share();
        kind = static_cast<int>(6 * share());
        friction = seed % 2 == 0 ? 0 : 0.5 * share();
        restitution = seed % 3 == 0 ? 0.5 * share() : 0;
        speed = 0.5 * std::pow(60, share());
        start = 3 * size * share();
        gap = seed % 5 == 0 ? 1e-4 * share() : 0;
    }
    double height() const { return kind == 2 ? 0.5 * radius : kind == 3 ? 0.7 * radius : radius; }
    ShapeDef shape() const {
        const Material material{.friction = friction, .restitution = restitution};
        const double r = radius, inner = 0.8 * radius;
        switch (kind) {
            case 0: return box({r, r}, material);
            case 1: return circle(r, material);
            case 2: return capsule({-r, 0}, {r, 0}, 0.5 * r, material);
            case 3: return box({r, 0.7 * r}, material);
            case 4: return polygon({{-r, -r}, {r, -r}, {0.5 * r, r}}, material);
            default:
                return {.shape = Polygon{{{-inner, -inner}, {inner, -inner}, {inner, inner}, {-inner, inner}}, 0.2 * r},
                        .material = material};
        }
    }
};

enum class Floor { Whole, Fixed, Loose };
struct Ride {
    double way = 0, hop = 0;  ///< along the floor, and the most up or down [m]
};

constexpr int boxesOfFloor = 40;

void lay(World& world, const Slide& slide, Floor floor) {
    const Rot turned = Rot::fromAngle(slide.angle);
    const auto place = [&](double x, double y) { return Vec2(turned * Vec2(x, y)); };
    const Material top{.density = 20, .friction = std::max(slide.friction, 0.3), .restitution = slide.restitution};
    const double middle = slide.size * (boxesOfFloor - 1), half = slide.size * boxesOfFloor;
    if (floor == Floor::Whole) {
        world.add({.type = BodyType::Static,
                   .position = place(middle, -slide.size),
                   .angle = slide.angle,
                   .shapes = {box({half, slide.size}, top)}});
        return;
    }
    if (floor == Floor::Loose)
        world.add({.type = BodyType::Static,
                   .position = place(middle, -3 * slide.size),
                   .angle = slide.angle,
                   .shapes = {box({half + 10, slide.size}, {.friction = 1})}});
    for (int i = 0; i < boxesOfFloor; ++i)
        world.add({.type = floor == Floor::Loose ? BodyType::Dynamic : BodyType::Static,
                   .position = place((2 * slide.size + slide.gap) * i, -slide.size),
                   .angle = slide.angle,
                   .shapes = {box({slide.size, slide.size}, top)}});
}

/// What presses on the floor.
struct Load {
    double gravity = g, step = dt;  ///< [m/s^2, s]
    double weights = 0;             ///< a force on what slides, over its weight
};

Ride rideOver(const Slide& slide, Floor floor, const Load& load = {}) {
    const Rot turned = Rot::fromAngle(slide.angle);
    World world({.gravity = turned * Vec2(0, -load.gravity)});
    lay(world, slide, floor);
    const BodyId body = world.add({.position = turned * Vec2(slide.start, slide.height()),
                                   .angle = slide.angle,
                                   .velocity = turned * Vec2(slide.speed, 0),
                                   .shapes = {slide.shape()}});
    const double force = load.weights * load.gravity * world.body(body).mass();
    Ride ride;
    for (double time = 0; time < 400 * dt; time += load.step) {
        world.body(body).applyForce(turned * Vec2(0, -force));
        world.step(load.step);
        const Vec2 at = turned.inverse() * world.body(body).position();
        if (at.x() > 2 * slide.size * (boxesOfFloor - 3) - 2 * slide.radius) break;
        ride.way = at.x() - slide.start;
        ride.hop = std::max(ride.hop, std::fabs(at.y() - slide.height()));
    }
    return ride;
}

}  // namespace

TEST_CASE("what slides over boxes laid flush goes on as over one box", "[dynamics][flush]") {
    for (const Floor floor : {Floor::Fixed, Floor::Loose}) {
        double worstWay = 0, worstHop = 0;
        for (int seed = 0; seed < allCases(150); ++seed) {
            const Slide slide(static_cast<unsigned>(seed));
            const Ride ride = rideOver(slide, floor), whole = rideOver(slide, Floor::Whole);
            INFO((floor == Floor::Loose ? "loose, " : "fixed, ") << "seed " << seed << ", kind " << slide.kind);
            CHECK(std::fabs(ride.way - whole.way) < 0.01 * whole.way + 0.01);
            CHECK(ride.hop < whole.hop + 0.01);
            worstWay = std::max(worstWay, std::fabs(ride.way - whole.way) / (whole.way + 0.01));
            worstHop = std::max(worstHop, ride.hop - whole.hop);
        }
        CHECK(worstWay < 0.01);
        CHECK(worstHop < 0.01);
    }
}

TEST_CASE("nothing stops on boxes laid flush, at any gravity and step, and under a load", "[dynamics][flush]") {
    for (const Floor floor : {Floor::Fixed, Floor::Loose})
        for (int seed = 0; seed < allCases(200); ++seed) {
            Slide slide(static_cast<unsigned>(1000 + seed));
            std::mt19937 random(static_cast<unsigned>(seed));
            const auto share = [&] { return std::uniform_real_distribution<double>(0, 1)(random); };
            slide.friction = slide.restitution = 0;
            const Load load{5 * std::pow(10, share()), 1 / (25 * std::pow(9.6, share())), 3 * share()};
            const Ride ride = rideOver(slide, floor, load), whole = rideOver(slide, Floor::Whole, load);
            INFO((floor == Floor::Loose ? "loose, " : "fixed, ")
                 << "seed " << seed << ", kind " << slide.kind << ", gravity " << load.gravity << ", " << 1 / load.step
                 << " Hz, load " << load.weights);
            CHECK(ride.way > 0.8 * whole.way);
            CHECK(ride.hop < whole.hop + 0.02);
        }
}

TEST_CASE("a box that is pressed to a wall of boxes laid flush falls freely", "[dynamics][flush]") {
    for (const double gravity : {5.0, 10.0, 50.0})
        for (const double step : {1.0 / 30, 1.0 / 60, 1.0 / 240})
            for (const double weights : {0.5, 3.0}) {
                World world({.gravity = {0, -gravity}});
                for (int i = 0; i < 60; ++i)
                    world.add({.type = BodyType::Static,
                               .position = {0.5, 1.5 - i},
                               .shapes = {box({0.5, 0.5}, {.friction = 0})}});
                const BodyId body = world.add({.position = {-0.25, 0}, .shapes = {box({0.25, 0.25}, {.friction = 0})}});
                const double weight = world.body(body).mass() * gravity;
                double time = 0;
                for (; 0.5 * gravity * time * time < 45; time += step) {
                    world.body(body).applyForce({weights * weight, 0});
                    world.step(step);
                }
                const double fallen = 0.5 * gravity * time * time;
                INFO("gravity " << gravity << ", step " << step << " s, pressed with " << weights << " weights");
                CHECK(world.body(body).position().y() < -0.97 * fallen);
            }
}

TEST_CASE("a step in a floor of boxes stops what slides against it", "[dynamics][flush]") {
    for (const double step : {0.02, 0.1, 0.5}) {
        INFO("a step of " << step << " m");
        World world;
        for (int i = 0; i < 20; ++i)
            world.add({.type = BodyType::Static,
                       .position = {2.0 * i, i < 8 ? -1 : -1 + step},
                       .shapes = {box({1, 1}, {.friction = 0})}});
        const BodyId body =
            world.add({.position = {1, 0.4}, .velocity = {3, 0}, .shapes = {box({0.4, 0.4}, {.friction = 0})}});
        for (int tick = 0; tick < 400; ++tick) world.step(dt);
        CHECK(world.body(body).position().x() < 15.01);
    }
}
