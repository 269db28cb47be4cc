// SPDX-License-Identifier: MIT
#include <plumb/forces/explosion.h>

#include <algorithm>

#include <plumb/math/check.h>

namespace plumb {
namespace {

void requireSound(const Explosion& explosion, const BlastTarget& target) {
    requireNotNegative(explosion.radius, "Explosion", ".radius");
    requireNotNegative(explosion.falloff, "Explosion", ".falloff");
    requireFinite(explosion.impulsePerLength, "Explosion", ".impulsePerLength");
    requireNotNegative(target.width, "BlastTarget", ".width");
}

/// 1 in full, 0 beyond the falloff.
double strengthAt(const Explosion& explosion, double distance) {
    if (distance <= explosion.radius) return 1;
    const double beyond = distance - explosion.radius;
    return beyond < explosion.falloff ? 1 - beyond / explosion.falloff : 0;
}

}  // namespace

Blast blastOn(const Explosion& explosion, const BlastTarget& target) {
    requireSound(explosion, target);
    Vec2 point = target.nearest;
    const double distance = (point - explosion.center).norm();
    if (distance == 0) point = target.centerOfMass;
    const Vec2 away = point - explosion.center;
    const double length = away.norm();
    if (length == 0) return {{0, 0}, point};
    const double impulse = explosion.impulsePerLength * target.width * strengthAt(explosion, distance);
    return {impulse * (away / length), point};
}

double widthAcross(std::span<const Vec2> points, double radius, const Vec2& direction) {
    requireNotNegative(radius, "widthAcross: radius");
    const double length = direction.norm();
    if (points.empty() || length == 0) return 0;
    const Vec2 across = perp(direction) / length;
    double least = across.dot(points[0]), most = least;
    for (const Vec2& point : points) {
        least = std::min(least, across.dot(point));
        most = std::max(most, across.dot(point));
    }
    return most - least + 2 * radius;
}

}  // namespace plumb
