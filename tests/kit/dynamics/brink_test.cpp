// SPDX-License-Identifier: MIT
// What becomes of a body that slides over a convex corner of a chain, seen from the far side of the segment beyond it?
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <plumb/math/random.h>
#include <plumb/plumb.h>
#include "cases.h"
#include "catch.h"
#include "kit/dynamics/sliders.h"
#include "kit/usual_world.h"

using namespace plumb;
using namespace plumb::test;

namespace {

constexpr double degree = std::numbers::pi / 180;

Slider brinkSlider(Random& random) {
    const double size = random.uniform(0.1, 0.8);
    return sliderOf(random.integer(0, 3), size, smooth);
}

/// A level floor, in pieces, that ends at the origin, where the line turns down; below it goes on anyhow.
struct Brink {
    std::vector<Vec2> points;
    double forward = 1;  ///< or -1: the way to the brink
};

Brink randomBrink(Random& random, double turn) {
    Brink brink{{}, random.integer(0, 1) == 0 ? 1.0 : -1.0};
    const Vec2 drop(std::cos(turn), -std::sin(turn));
    const double foot = random.uniform(-150, 150) * degree - turn;
    brink.points = {8 * drop + 4 * Vec2(std::cos(foot), std::sin(foot)), 8 * drop, {0, 0}};
    const double piece = random.integer(0, 1) == 0 ? 200 : random.uniform(0.05, 1);
    double end = 0;
    for (int i = 0; i < 20; ++i) brink.points.emplace_back(end -= piece, 0);
    brink.points.emplace_back(end - 200, 0);
    for (Vec2& point : brink.points) point.x() *= brink.forward;
    if (random.integer(0, 1) == 0) std::reverse(brink.points.begin(), brink.points.end());
    return brink;
}

/// Least share of the speed that is kept, and the contact that leans back most, until the middle is over the brink.
struct BrinkSlide {
    double kept = 1;
    double back = 0;  ///< cosine, of a contact's way to the body and its way back
    bool over = false;
};

/// From where a body starts above the floor, and how fast it comes down.
struct Fall {
    double height = 0;  ///< [m]
    double speed = 0;   ///< [m/s]
};

BrinkSlide slideOver(const Brink& brink, const Slider& slider, double speed, double gravity, const Fall& fall = {}) {
    World world({.gravity = {0, -gravity}, .sleeping = false});
    world.add({.type = BodyType::Static, .shapes = {chain(brink.points, smooth)}});
    const double f = brink.forward, run = std::clamp(speed, 0.1, 20.0);
    const BodyId body = world.add({.position = {-f * run, slider.below + fall.height},
                                   .velocity = {f * speed, -fall.speed},
                                   .shapes = {slider.shape}});
    BrinkSlide slide;
    for (int tick = 0; tick < 120 && !slide.over; ++tick) {
        world.step(dt);
        const auto view = world.body(body);
        for (const Contact& contact : view.contacts()) {
            const bool fromChain = contact.shapeB.body == body;
            slide.back = std::max(slide.back, (fromChain ? -f : f) * contact.normal.x());
        }
        slide.over = f * view.position().x() > 0;
        // In the step in which its middle passes the brink it may begin to tip.
        if (!slide.over) slide.kept = std::min(slide.kept, f * view.velocity().x() / speed);
    }
    return slide;
}

}  // namespace

TEST_CASE("a disc of 40 cm at 1 m/s goes over the brink of a chain, and does not stop 75 mm before it",
          "[dynamics][chain]") {
    World world;
    world.add({.type = BodyType::Static, .shapes = {chain({{2, -5}, {2, 0}, {0, 0}}, smooth)}});
    const BodyId disc = world.add({.position = {0.6, 0.4}, .velocity = {1, 0}, .shapes = {circle(0.4, smooth)}});
    for (int tick = 0; tick < 120; ++tick) {
        world.step(dt);
        REQUIRE(world.body(disc).velocity().x() > 1 - 1e-6);
    }
    CHECK(world.body(disc).position().x() > 2.4);
    CHECK(world.body(disc).position().y() < 0);
}

TEST_CASE("10,000 slides over brinks of 45, 90 and 135 degrees at 0.1 to 100 m/s lose no speed and feel no drop",
          "[dynamics][chain]") {
    for (int seed = 0; seed < cases(10'000); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const double turn = 45 * degree * random.integer(1, 3);
        const Brink brink = randomBrink(random, turn);
        const Slider slider = brinkSlider(random);
        const double speed = std::pow(10, random.uniform(-1, 2));
        const double gravity = random.integer(0, 1) == 0 ? 0 : 9.81;
        INFO("seed " << seed << ": " << slider.name << " at " << speed << " m/s, turn " << turn / degree << ", gravity "
                     << gravity);
        const BrinkSlide slide = slideOver(brink, slider, speed, gravity);
        CHECK(slide.over);
        // Rounded to the solver's floats once, and never again.
        CHECK(slide.kept >= 1 - 0x1p-24);
        CHECK(slide.back < 1e-6);
    }
}

TEST_CASE("10,000 bodies that come down at 0 to 20 m/s near a brink go on over it as fast as they came",
          "[dynamics][chain]") {
    for (int seed = 0; seed < cases(10'000); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const double turn = 45 * degree * random.integer(1, 3);
        const Brink brink = randomBrink(random, turn);
        const Slider slider = brinkSlider(random);
        const double speed = std::pow(10, random.uniform(-1, 2));
        const Fall fall{random.uniform(0, 2), random.uniform(0, 20)};
        INFO("seed " << seed << ": " << slider.name << " at " << speed << " m/s, turn " << turn / degree << ", from "
                     << fall.height << " m at " << fall.speed << " m/s");
        const BrinkSlide slide = slideOver(brink, slider, speed, 9.81, fall);
        CHECK(slide.back < 1e-6);
        // Floats round what stops a fall of 20 m/s, over a few steps, along a floor level to a rounding.
        CHECK(slide.kept * speed >= speed - 8 * 20 * 0x1p-24 - speed * 0x1p-24);
    }
}

namespace {

bool crosses(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    const auto side = [](const Vec2& from, const Vec2& to, const Vec2& point) {
        return cross(Vec2(to - from), Vec2(point - from)) > 0;
    };
    return side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b);
}

bool crossesItself(const std::vector<Vec2>& line) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        for (std::size_t j = i + 2; j + 1 < line.size(); ++j)
            if (crosses(line[i], line[i + 1], line[j], line[j + 1])) return true;
    return false;
}

/// A line from far left to far right that goes up and down by slopes, walls and overhangs.
std::vector<Vec2> randomTerrain(Random& random) {
    std::vector<Vec2> points{{-4000, 0}, {-6, 0}};
    while (points.back().x() < 6) {
        const double length = random.integer(0, 3) == 0 ? random.uniform(0.02, 0.2) : random.uniform(0.3, 2);
        const double high = random.uniform(0.2, 2);
        const double lean = high / std::tan(45 * degree * random.integer(1, 3));
        const bool down = random.integer(0, 1) == 0;
        std::vector<Vec2> longer = points;
        longer.push_back(points.back() + Vec2(length + std::fabs(lean), 0));
        longer.push_back(longer.back() + Vec2(lean, down ? -high : high));
        if (!crossesItself(longer)) points = longer;
    }
    points.emplace_back(4000, points.back().y());
    if (crossesItself(points)) return randomTerrain(random);
    if (random.integer(0, 1) == 0) std::reverse(points.begin(), points.end());
    return points;
}

/// By how often a ray straight up crosses it: of a line from far left to far right.
bool isBelow(const std::vector<Vec2>& line, const Vec2& point) {
    bool below = false;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Vec2 &a = line[i], &b = line[i + 1];
        if ((a.x() > point.x()) == (b.x() > point.x())) continue;
        const double height = a.y() + (b.y() - a.y()) * (point.x() - a.x()) / (b.x() - a.x());
        below ^= height > point.y();
    }
    return below;
}

}  // namespace

TEST_CASE("3,000 bodies at 0.1 to 100 m/s stay on their side of chains with brinks, hollows, barbs and overhangs",
          "[dynamics][chain]") {
    int sides[2] = {0, 0};
    for (int seed = 0; seed < cases(3000); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const std::vector<Vec2> terrain = randomTerrain(random);
        World world({.gravity = {0, random.integer(-1, 1) * 9.81}});
        world.add({.type = BodyType::Static, .shapes = {chain(terrain, smooth)}});
        const Slider slider = brinkSlider(random);
        const double speed = std::pow(10, random.uniform(-1, 2)), angle = random.uniform(0, 2 * std::numbers::pi);
        const Vec2 at(random.uniform(-6, 6), random.uniform(-4, 4));
        const double turned = random.uniform(0, 2 * std::numbers::pi);
        if (!world.overlapShape(slider.shape.shape, {at, Rot::fromAngle(turned)}).empty()) continue;
        const BodyId body = world.add({.position = at,
                                       .angle = turned,
                                       .velocity = speed * Vec2(std::cos(angle), std::sin(angle)),
                                       .shapes = {slider.shape}});
        const bool below = isBelow(terrain, at);
        ++sides[below ? 1 : 0];
        INFO("seed " << seed << ": " << slider.name << " at " << speed << " m/s" << (below ? ", below" : ", above"));
        for (int tick = 0; tick < 180; ++tick) {
            world.step(dt);
            REQUIRE(isBelow(terrain, world.body(body).position()) == below);
        }
    }
    CHECK(sides[0] > cases(500));
    CHECK(sides[1] > cases(500));
}
