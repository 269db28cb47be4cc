// SPDX-License-Identifier: MIT
#include <games/artillery/aim.h>

#include <algorithm>
#include <cmath>

#include <plumb/math/trig.h>

namespace plumb::games::artillery {

Vec2 directionOf(const Aim& aim) {
    const SinCos turned = sinCos(aim.elevation * (3.14159265358979323846 / 1800));
    return {aim.facing * turned.cos, turned.sin};
}

double speedOf(int charge) {
    return slowestShot + (fastestShot - slowestShot) * charge / fullCharge;
}

int chargeFor(double speed) {
    const double charge = std::round((speed - slowestShot) / (fastestShot - slowestShot) * fullCharge);
    return static_cast<int>(std::clamp(charge, 0.0, double{fullCharge}));
}

Vec2 muzzleFrom(const Vec2& direction) {
    return Vec2(0, 0.15) + 1.15 * direction;
}

BodyDef shellDef(const Vec2& gunner, const Aim& aim, const Weapon& weapon) {
    const Vec2 direction = directionOf(aim);
    ShapeDef disc = circle(shellRadius, {.friction = 0.5, .restitution = weapon.restitution});
    disc.filter = {.category = Shot, .mask = Ground | Thing | Person | Air};
    const Mass mass{.mass = shellMass, .inertia = shellMass * shellRadius * shellRadius / 2};
    return {.position = gunner + muzzleFrom(direction),
            .velocity = speedOf(aim.charge) * direction,
            .canSleep = false,
            .mass = mass,
            .shapes = {disc}};
}

}  // namespace plumb::games::artillery
