// SPDX-License-Identifier: MIT
#include <plumb/collide/moving_circles.h>

#include <cmath>
#include <string>

#include <plumb/collide/detail/sweep_limits.h>

namespace plumb {

namespace {

void requireSound(const MovingCircle& circle, const std::string& name) {
    requireNotNegative(circle.radius, name, ".radius");
    requireWithin(circle.radius, 0, maxMagnitude, name, ".radius");
    requireInRange(circle.position, name, ".position");
    requireInRange(circle.velocity, name, ".velocity");
}

double lengthOf(const Vec2& v) {
    return std::sqrt(v.dot(v));
}

Touch touchAt(double time, const MovingCircle& a, const MovingCircle& b) {
    const Vec2 centerA = a.position + a.velocity * time, centerB = b.position + b.velocity * time;
    const Vec2 between = centerB - centerA;
    const double length = lengthOf(between);
    const Vec2 normal = length > 0 ? Vec2(between / length) : Vec2(0, 1);
    return {time, 0.5 * (centerA + normal * a.radius) + 0.5 * (centerB - normal * b.radius), normal};
}

}  // namespace

std::optional<Touch> firstTouch(const MovingCircle& a, const MovingCircle& b) {
    requireSound(a, "MovingCircle a");
    requireSound(b, "MovingCircle b");
    const Vec2 position = b.position - a.position, velocity = b.velocity - a.velocity;
    const double radii = a.radius + b.radius, distance = lengthOf(position);
    const double outside = (distance - radii) * (distance + radii);
    if (outside <= 0) return touchAt(0, a, b);
    const double closing = -position.dot(velocity);
    const double limit = radii * lengthOf(velocity), aside = std::fabs(cross(position, velocity));
    if (!(closing > 0) || !(aside <= limit)) return std::nullopt;
    const double time = outside / (closing + std::sqrt((limit - aside) * (limit + aside)));
    return std::isfinite(time) ? std::optional<Touch>(touchAt(time, a, b)) : std::nullopt;
}

}  // namespace plumb
