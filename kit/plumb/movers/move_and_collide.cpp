// SPDX-License-Identifier: MIT
#include <plumb/movers/move_and_collide.h>

#include <cmath>

#include <plumb/math/check.h>
#include <plumb/movers/detail/slide_probe.h>

namespace plumb {

FreeMotion testMove(const World& world, BodyId body, const Vec2& displacement, double skin) {
    requireFinite(displacement, "testMove: displacement");
    requirePositive(skin, "testMove: skin");
    const SlideSettings settings{.skin = skin};
    const detail::SlideProbe probe(world, body, settings, 0);
    const double length = std::sqrt(displacement.dot(displacement));
    const detail::FreePath path = probe.freePath(world.body(body).position(), displacement);
    if (!path.hit) return {displacement};
    return {displacement * (path.length / length), path.hit};
}

FreeMotion moveAndCollide(World& world, BodyId body, const Vec2& displacement, double dt, double skin) {
    requirePositive(dt, "moveAndCollide: dt");
    Body moved = world.body(body);
    if (moved.type() != BodyType::Kinematic)
        refuse("moveAndCollide: body", "is not kinematic: set its type to Kinematic");
    const FreeMotion free = testMove(world, body, displacement, skin);
    moved.setVelocity(free.displacement / dt);
    moved.setAngularVelocity(0);
    return free;
}

}  // namespace plumb
