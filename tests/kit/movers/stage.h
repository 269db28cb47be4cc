// SPDX-License-Identifier: MIT
// What do tests of movers stand on?
#pragma once
#include <vector>

#include <plumb/movers/platform_mover.h>

#include "kit/usual_world.h"

namespace plumb::test {

inline constexpr double skin = 1e-3;
inline constexpr PlatformInput still{};

/// In each shape that a hero can have.
inline std::vector<ShapeDef> heroes() {
    return {box({0.4, 0.9}), capsule({0, -0.5}, {0, 0.5}, 0.4), circle(0.5), roundedBox({0.3, 0.8}, 0.1)};
}

inline BodyId addStatic(World& world, const Vec2& place, const ShapeDef& shape, double angle = 0) {
    return world.add({.type = BodyType::Static, .position = place, .angle = angle, .shapes = {shape}});
}
inline BodyId addKinematic(World& world, const Vec2& place, const ShapeDef& shape, const Vec2& velocity = {0, 0}) {
    return world.add({.type = BodyType::Kinematic, .position = place, .velocity = velocity, .shapes = {shape}});
}

/// A body that falls by gravity and goes to the side at the speed wanted.
struct SlidingMover {
    BodyId body;
    SlideSettings settings = {};
    Slide slide = {};
    double gravity = 9.81;

    /// One tick, with the world's; level is the speed wanted to the right [m/s].
    const Slide& step(World& world, double level, double tick) {
        move(world, level, tick);
        world.step(tick);
        return slide;
    }
    const Slide& move(World& world, double level, double tick) {
        const double rise = slide.isOnFloor ? 0 : slide.velocity.y() - gravity * tick;
        slide = moveAndSlide(world, body, {.velocity = {level, rise}, .dt = tick}, settings, slide);
        return slide;
    }
    /// Until it stands.
    void land(World& world, double tick = dt) {
        for (int i = 0; i < 600 && !slide.isOnFloor; ++i) step(world, 0, tick);
    }
};

/// How deep the body's shapes are in anything else's, by brute force; negative when they are clear of it [m].
inline double depthOf(const World& world, BodyId body, bool ofDynamic = false) {
    double deepest = -1e300;
    for (const BodyId other : world.bodies()) {
        if (other == body || (!ofDynamic && world.body(other).type() == BodyType::Dynamic)) continue;
        for (const ShapeId& mine : world.body(body).shapes())
            for (const ShapeId& theirs : world.body(other).shapes())
                if (!world.shape(theirs).def().oneWay && !world.shape(theirs).sensor())
                    deepest = std::max(deepest, -world.distance(mine, theirs).separation);
    }
    return deepest;
}

}  // namespace plumb::test
