// SPDX-License-Identifier: MIT
// An hour of random play in random levels.
#include <algorithm>
#include <cmath>
#include <vector>

#include <plumb/math/random.h>
#include <plumb/math/trig.h>
#include <plumb/movers/platform_mover.h>

#include "cases.h"
#include "catch.h"
#include "kit/movers/stage.h"

namespace plumb::test {

namespace {

/// A walled room of 40 m by 24 m with boxes, turned ones, hills, one-way slabs, lifts that come and go, and crates.
struct Level {
    World world;
    std::vector<BodyId> lifts;
    std::vector<Vec2> homes;
    std::vector<double> phases;
    Random random;

    explicit Level(std::uint64_t seed) : random(seed) {
        addStatic(world, {0, 0}, loop({{-20, 0}, {-20, 24}, {20, 24}, {20, 0}, {8, 0}, {5, 1.5}, {2, 1.5}, {0, 0}}));
        for (int i = 0; i < 14; ++i) {
            const Vec2 half(random.uniform(0.3, 2.5), random.uniform(0.15, 0.8));
            addStatic(world, place(), box(half), i % 3 == 0 ? random.uniform(-0.7, 0.7) : 0);
        }
        for (int i = 0; i < 6; ++i) {
            ShapeDef slab = box({random.uniform(0.5, 2), 0.1});
            slab.oneWay = Vec2(0, 1);
            addStatic(world, place(), slab);
        }
        for (int i = 0; i < 4; ++i) {
            homes.push_back(place());
            phases.push_back(random.uniform(0, 6));
            lifts.push_back(addKinematic(world, homes.back(), box({1.2, 0.2})));
        }
        for (std::size_t i = 0; i < lifts.size(); ++i) world.body(lifts[i]).setPose(liftAt(i, 0), turnOf(i, 0));
        for (int i = 0; i < 5; ++i)
            world.add({.position = place(), .shapes = {box({0.4, 0.4}, {.density = random.uniform(1, 60)})}});
    }
    Vec2 place() { return {random.uniform(-18, 18), random.uniform(3, 20)}; }

    Vec2 liftAt(std::size_t i, double time) const {
        const double t = time + phases[i];
        return homes[i] + Vec2(3 * sinCos(0.7 * t).sin, 2 * sinCos(0.9 * t).sin);
    }
    double turnOf(std::size_t i, double time) const { return i == 0 ? 0.4 * sinCos(time + phases[i]).sin : 0; }
    void moveLifts(double time) {
        for (std::size_t i = 0; i < lifts.size(); ++i)
            world.body(lifts[i]).moveTo(liftAt(i, time), turnOf(i, time), dt);
    }
};

/// Somewhere with room.
Vec2 freePlace(Level& level, const ShapeDef& hero) {
    for (;;) {
        const Vec2 at = level.place();
        if (level.world.overlapShape(hero.shape, {at, {}}).empty()) return at;
    }
}

/// May it be shifted so, as far as anything but what is one-way goes?
bool isFree(const World& world, const PlatformMover& mover, const Vec2& shift) {
    const BodyView body = world.body(mover.body());
    const ShapeDef def = world.shape(body.shapes()[0]).def();
    for (const CastHit& hit : world.castShapePieces(def.shape, body.pose(), shift, {}, mover.body()))
        if (!hit.oneWay) return false;
    return true;
}

}  // namespace

TEST_CASE("in an hour of random play in 120 random levels a mover is never in a wall, and goes where a way is open",
          "[movers]") {
    const int levels = cases(120), ticks = 30 * 60;
    int crushes = 0, moves = 0;
    for (int n = 0; n < levels; ++n) {
        Level level(1000 + static_cast<std::uint64_t>(n));
        const ShapeDef hero = heroes()[static_cast<std::size_t>(n) % 4];
        PlatformMover mover(addKinematic(level.world, freePlace(level, hero), hero));
        PlatformInput input;
        for (int tick = 0; tick < ticks; ++tick) {
            if (level.random.integer(0, 14) == 0) input.move = level.random.integer(-2, 2) / 2.0;
            if (level.random.integer(0, 9) == 0) input.jump = !input.jump;
            if (level.random.integer(0, 29) == 0) input.run = !input.run;
            input.down = level.random.integer(0, 9) == 0;
            level.moveLifts((tick + 1) * dt);
            const bool leftFree = isFree(level.world, mover, {-0.05, 0}),
                       rightFree = isFree(level.world, mover, {0.05, 0});
            const Vec2 before = level.world.body(mover.body()).position();
            const bool wasCrushed = mover.slide().crushed;
            const bool stood = mover.slide().isOnFloor;
            const double speed = mover.slide().velocity.x();
            const Slide& slide = mover.step(level.world, input, dt);
            level.world.step(dt);
            const Vec2 now = level.world.body(mover.body()).position();
            crushes += slide.crushed;
            const double depth = depthOf(level.world, mover.body());
            // 1e-9 m: a lift that turns is met as it is seen from itself.
            if (!slide.crushed && depth > 1e-9) FAIL("level " << n << ", tick " << tick << ": " << depth << " m deep");
            if (now.cwiseAbs().maxCoeff() > 24) FAIL("level " << n << ", tick " << tick << ": out of the room");
            // On the floor, with 5 cm of room, it goes where it is told, at the lesser of its speeds, on a slope of at
            // most 45 degrees.
            const bool asked = input.move != 0 && stood && slide.isOnFloor && !slide.crushed && !wasCrushed;
            if (!asked || level.world.body(slide.floor->shape.body).type() != BodyType::Static) continue;
            if (!(input.move > 0 ? rightFree : leftFree) || speed * input.move < 0) continue;
            ++moves;
            const double least = 0.7 * dt * std::min({std::fabs(speed), std::fabs(slide.velocity.x()), 2.0});
            const double went = (now - before).x() * (input.move > 0 ? 1 : -1);
            if (!(went > 0 && went >= least)) FAIL("level " << n << ", tick " << tick << ": stuck, " << went);
        }
    }
    CHECK(moves > 100 * levels);
    CHECK(crushes < levels * ticks / 20);
}

}  // namespace plumb::test
