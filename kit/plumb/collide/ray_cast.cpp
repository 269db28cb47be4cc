// SPDX-License-Identifier: MIT
#include <plumb/collide/ray_cast.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <plumb/collide/distance.h>
#include <plumb/math/detail/length.h>
#include <plumb/shapes/chain.h>
#include <plumb/shapes/detail/counts.h>

namespace plumb {

namespace {

/// In the frame of the shape; its way is not zero.
struct Ray {
    Vec2 from, way;
};

struct Meeting {
    double fraction = 0;
    Vec2 normal{0, 0};  ///< of any length; zero where it began inside or touching
};
using MaybeMeeting = std::optional<Meeting>;

MaybeMeeting inside() {
    return Meeting{};
}

MaybeMeeting meet(const Ray& ray, const Vec2& center, double radius) {
    const Vec2 start = ray.from - center;
    if (start.dot(start) <= radius * radius) return inside();
    const double towards = -start.dot(ray.way);
    if (!(towards > 0)) return std::nullopt;
    const double whole = ray.way.dot(ray.way);
    const double aside = cross(start, ray.way);
    const double chord = radius * radius * whole - aside * aside;
    if (!(chord >= 0)) return std::nullopt;
    const double fraction = std::max((towards - std::sqrt(chord)) / whole, 0.0);
    if (fraction > 1) return std::nullopt;
    return Meeting{fraction, start + ray.way * fraction};
}

MaybeMeeting meet(const Ray& ray, const Circle& circle) {
    return meet(ray, circle.center, circle.radius);
}

/// The ray runs along the line that the segment is on.
MaybeMeeting meetInLine(const Ray& ray, const Vec2& toStart, const Vec2& toEnd) {
    const double first = toStart.dot(ray.way), last = toEnd.dot(ray.way);
    if (first < 0 && last < 0) return std::nullopt;
    if (!(first > 0 && last > 0)) return inside();
    const double fraction = std::min(first, last) / ray.way.dot(ray.way);
    if (fraction > 1) return std::nullopt;
    return Meeting{fraction, first < last ? Vec2(toStart - toEnd) : Vec2(toEnd - toStart)};
}

/// Is a cross product of these nothing but rounding?
bool isRounding(double product, const Vec2& a, const Vec2& b) {
    constexpr double fourRoundings = 2 * std::numeric_limits<double>::epsilon();
    return std::fabs(product) <= fourRoundings * (std::fabs(a.x() * b.y()) + std::fabs(a.y() * b.x()));
}

/// Both ends on one side of the ray's line: missed. The side of a point is the same for all segments that share it.
MaybeMeeting meet(const Ray& ray, const Vec2& start, const Vec2& end) {
    const Vec2 toStart = start - ray.from, toEnd = end - ray.from, edge = end - start;
    const double sideStart = cross(ray.way, toStart), sideEnd = cross(ray.way, toEnd);
    if (isRounding(sideStart, ray.way, toStart) && isRounding(sideEnd, ray.way, toEnd))
        return meetInLine(ray, toStart, toEnd);
    if ((sideStart > 0 && sideEnd > 0) || (sideStart < 0 && sideEnd < 0)) return std::nullopt;
    // By the place on the segment, not by that on the ray: where the two are nearly in line only it is sure.
    const double across = sideEnd - sideStart;
    const Vec2 place = toStart - edge * (sideStart / across);
    const double fraction = place.dot(ray.way) / ray.way.dot(ray.way);
    if (fraction == 0) return inside();
    if (!(fraction > 0 && fraction <= 1)) return std::nullopt;
    return Meeting{fraction, across > 0 ? perp(edge) : Vec2(-perp(edge))};
}

MaybeMeeting meet(const Ray& ray, const Segment& segment) {
    return meet(ray, segment.start, segment.end);
}

MaybeMeeting meet(const Ray& ray, const Chain& chain) {
    requireCount(chain);
    MaybeMeeting first;
    const std::size_t count = chain.points.size();
    for (std::size_t i = 0; i < (chain.closed ? count : count - 1); ++i) {
        const MaybeMeeting here = meet(ray, chain.points[i], chain.points[i + 1 < count ? i + 1 : 0]);
        if (here && (!first || here->fraction < first->fraction)) first = here;
    }
    return first;
}

MaybeMeeting meet(const Ray& ray, const Capsule& capsule) {
    const Vec2 edge = capsule.end - capsule.start;
    const double whole = edge.dot(edge);
    Vec2 normal = perp(edge) / std::sqrt(whole);
    double height = normal.dot(ray.from - capsule.start), fraction = 0;
    if (height < 0) normal = -normal;
    height = std::fabs(height);
    const bool beside = height > capsule.radius;
    if (beside) {
        const double closing = -normal.dot(ray.way);
        if (!(closing > 0) || height - capsule.radius > closing) return std::nullopt;
        fraction = (height - capsule.radius) / closing;
    }
    const double along = edge.dot(ray.from + ray.way * fraction - capsule.start);
    if (along < 0) return meet(ray, capsule.start, capsule.radius);
    if (along > whole) return meet(ray, capsule.end, capsule.radius);
    return beside ? Meeting{fraction, normal} : inside();
}

struct Edge {
    const Vec2& start;
    const Vec2& end;
    Vec2 way() const { return end - start; }
    Vec2 outward() const { return -perp(way()); }
};

Edge edgeOf(const Polygon& polygon, std::size_t i) {
    const std::size_t next = i + 1 < polygon.vertices.size() ? i + 1 : 0;
    return {polygon.vertices[i], polygon.vertices[next]};
}

/// Begins where every edge, moved out by the radius, has it behind it: inside, or before a corner that is round.
MaybeMeeting meetFromWithinEdges(const Ray& ray, const Polygon& polygon) {
    bool inCore = true;
    double least = std::numeric_limits<double>::infinity();
    Vec2 nearest = polygon.vertices.front();
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
        const Edge edge = edgeOf(polygon, i);
        const Vec2 way = edge.way(), start = ray.from - edge.start;
        if (edge.outward().dot(start) <= 0) continue;
        inCore = false;
        const double part = std::clamp(start.dot(way) / way.dot(way), 0.0, 1.0);
        const Vec2 apart = start - way * part;
        if (apart.dot(apart) >= least) continue;
        least = apart.dot(apart);
        nearest = part < 0.5 ? edge.start : edge.end;
    }
    if (inCore || least <= polygon.radius * polygon.radius) return inside();
    return meet(ray, nearest, polygon.radius);
}

MaybeMeeting meet(const Ray& ray, const Polygon& polygon) {
    requireCount(polygon);
    const double radius = polygon.radius;
    double enter = -1, leave = 1;
    std::size_t entered = 0;
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
        const Vec2 outward = edgeOf(polygon, i).outward();
        const double extra = radius > 0 ? radius * std::sqrt(outward.dot(outward)) : 0.0;
        const double depth = outward.dot(polygon.vertices[i] - ray.from) + extra;
        const double going = outward.dot(ray.way);
        if (depth < 0) {
            if (!(going < 0)) return std::nullopt;
            const double fraction = depth / going;
            if (fraction > enter) entered = i;
            enter = std::max(enter, fraction);
        } else if (going > 0) {
            leave = std::min(leave, depth / going);
        }
    }
    if (enter > leave) return std::nullopt;
    if (enter < 0) return radius > 0 ? meetFromWithinEdges(ray, polygon) : inside();
    const Edge edge = edgeOf(polygon, entered);
    if (radius > 0) {
        const double along = edge.way().dot(ray.from + ray.way * enter - edge.start);
        if (along < 0) return meet(ray, edge.start, radius);
        if (along > edge.way().dot(edge.way())) return meet(ray, edge.end, radius);
    }
    return Meeting{enter, edge.outward()};
}

MaybeMeeting meet(const Ray& ray, const TileMap& map) {
    MaybeMeeting first;
    for (const Shape& piece : piecesOf(map)) {
        const auto* segment = std::get_if<Segment>(&piece);
        const MaybeMeeting here = segment != nullptr ? meet(ray, *segment) : meet(ray, std::get<Polygon>(piece));
        if (here && (!first || here->fraction < first->fraction)) first = here;
    }
    return first;
}

/// A ray of no length.
std::optional<CastPoint> castPoint(const Vec2& point, const Shape& shape, const Transform& pose) {
    const Distance here = distance(shape, pose, Circle{.radius = 0}, {point, {}});
    if (!(here.separation <= 0 && std::isfinite(here.separation))) return std::nullopt;
    return CastPoint{point, here.normal, 0};
}

}  // namespace

std::optional<CastPoint> castRay(const Vec2& from, const Vec2& to, const Shape& shape, const Transform& pose) {
    const Vec2 way = to - from;
    if (!(way.dot(way) > 0)) return castPoint(from, shape, pose);
    const Rot back = pose.rotation.inverse();
    const Ray ray{back * Vec2(from - pose.position), back * way};
    const MaybeMeeting meeting = std::visit([&](const auto& outline) { return meet(ray, outline); }, shape);
    if (!meeting) return std::nullopt;
    if (meeting->normal.isZero(0)) {
        // Nothing of what is not a number is outside of an edge.
        const bool sound = ray.from.allFinite() && ray.way.allFinite();
        return sound ? std::optional<CastPoint>({from, -detail::unit(way), 0}) : std::nullopt;
    }
    const Vec2 point = from + way * meeting->fraction;
    if (!point.allFinite()) return std::nullopt;
    return CastPoint{point, pose.rotation * detail::unit(meeting->normal), meeting->fraction};
}

}  // namespace plumb
