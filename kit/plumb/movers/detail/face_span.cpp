// SPDX-License-Identifier: MIT
#include <plumb/movers/detail/face_span.h>

#include <algorithm>
#include <limits>

namespace plumb::detail {

namespace {

struct Core {
    std::vector<Vec2> corners = {};
    double radius = 0;
};

Core coreOf(const Shape& shape) {
    if (const auto* circle = std::get_if<Circle>(&shape)) return {{circle->center}, circle->radius};
    if (const auto* capsule = std::get_if<Capsule>(&shape)) return {{capsule->start, capsule->end}, capsule->radius};
    if (const auto* polygon = std::get_if<Polygon>(&shape)) return {polygon->vertices, polygon->radius};
    if (const auto* segment = std::get_if<Segment>(&shape)) return {{segment->start, segment->end}};
    if (const auto* chain = std::get_if<Chain>(&shape)) return {chain->points};
    return {};
}

}  // namespace

FaceSpan faceSpan(const Shape& shape, const Transform& pose, const Vec2& direction, const Vec2& line) {
    constexpr double inf = std::numeric_limits<double>::infinity(), flush = 1e-3;
    const Core core = coreOf(shape);
    double farthest = -inf;
    for (const Vec2& corner : core.corners) farthest = std::max(farthest, (pose * corner).dot(direction));
    FaceSpan span{inf, -inf, farthest + core.radius};
    for (const Vec2& corner : core.corners) {
        const Vec2 at = pose * corner;
        if (at.dot(direction) < farthest - flush) continue;
        span.low = std::min(span.low, at.dot(line));
        span.high = std::max(span.high, at.dot(line));
    }
    return span;
}

}  // namespace plumb::detail
