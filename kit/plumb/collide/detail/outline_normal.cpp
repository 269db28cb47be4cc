// SPDX-License-Identifier: MIT
#include <plumb/collide/detail/outline_normal.h>

#include <cmath>

#include <plumb/math/detail/length.h>

namespace plumb {

namespace {

/// Above roundings of a unit vector, below any turn of an outline [-].
constexpr double tiny = 1e-9;

/// Out over a hollow leans the way to what is within a one-way tile alone, about the corner below its top, where the
/// outline goes on the other way; to all else, no more than by roundings [-].
constexpr double leaning = 1e-3;

/// A unit vector turned to the right.
Vec2 rightOf(const Vec2& along) {
    return {along.y(), -along.x()};
}

}  // namespace

std::optional<Vec2> outlineNormal(const Segment& segment, const Vec2& normal) {
    const Vec2 along = detail::unit(segment.end - segment.start), own = rightOf(along);
    const double lean = normal.dot(along);
    const auto outward = [&]() { return normal.dot(own) > 0 ? std::optional(own) : std::nullopt; };
    if (std::fabs(lean) <= tiny) return outward();
    const std::optional<Vec2>& beyond = lean > 0 ? segment.after : segment.before;
    if (!beyond) return outward();  // it goes on into a one-way top
    // On from the joint, away from this segment.
    Vec2 on = detail::unit(*beyond - (lean > 0 ? segment.end : segment.start));
    const bool under = on.dot(own) > tiny && std::fabs(lean) > leaning;
    if (under) on = -on;
    const bool corner = on.dot(own) < -tiny;
    // A hollow narrower than a quarter turn lies all on this side of the joint: what leans on was met through a wall.
    const bool narrow = !corner && on.dot(lean > 0 ? along : Vec2(-along)) < -tiny;
    if (narrow) return std::nullopt;
    if (!corner) return outward();
    return normal.dot(on) <= tiny ? std::optional(normal) : std::nullopt;
}

}  // namespace plumb
