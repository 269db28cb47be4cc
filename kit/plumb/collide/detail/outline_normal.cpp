// SPDX-License-Identifier: MIT
#include <plumb/collide/detail/outline.h>

#include <cmath>

#include <plumb/math/detail/length.h>

namespace plumb {

namespace {

/// Above the rounding error of a unit vector, below any turn of an outline [-].
constexpr double tiny = 1e-9;

/// A normal that leans outwards over a concave corner by more than this belongs to a shape within a one-way tile, about
/// the corner below its top, where the outline turns back; all other normals lean by rounding errors only [-].
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
    if (!beyond) return outward();  // it continues into a one-way top
    // Along the neighbour, away from this segment.
    Vec2 on = detail::unit(*beyond - (lean > 0 ? segment.end : segment.start));
    const bool under = on.dot(own) > tiny && std::fabs(lean) > leaning;
    if (under) on = -on;
    const bool corner = on.dot(own) < -tiny;
    // A concave corner of less than 90 degrees lies on this side of the vertex: a hit that leans outwards came through
    // a wall.
    const bool narrow = !corner && on.dot(lean > 0 ? along : Vec2(-along)) < -tiny;
    if (narrow) return std::nullopt;
    if (!corner) return outward();
    return normal.dot(on) <= tiny ? std::optional(normal) : std::nullopt;
}

}  // namespace plumb
