// SPDX-License-Identifier: MIT
#include <plumb/collide/ray_cast.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <plumb/collide/distance.h>
#include <plumb/math/detail/length.h>
#include <plumb/shapes/chain.h>
#include <plumb/shapes/detail/point_sets.h>

namespace plumb {

namespace {

/// In the frame of the shape; its direction is not zero.
struct Ray {
    Vec2 from, direction;
};

struct RayHit {
    double fraction = 0;
    Vec2 normal{0, 0};  ///< of any length; zero where the ray starts inside or touching
};
using MaybeHit = std::optional<RayHit>;

MaybeHit startsInside() {
    return RayHit{};
}

MaybeHit intersect(const Ray& ray, const Vec2& center, double radius) {
    const Vec2 start = ray.from - center;
    if (start.dot(start) <= radius * radius) return startsInside();
    const double towards = -start.dot(ray.direction);
    if (!(towards > 0)) return std::nullopt;
    const double whole = ray.direction.dot(ray.direction);
    const double aside = cross(start, ray.direction);
    const double chord = radius * radius * whole - aside * aside;
    if (!(chord >= 0)) return std::nullopt;
    const double fraction = std::max((towards - std::sqrt(chord)) / whole, 0.0);
    if (fraction > 1) return std::nullopt;
    return RayHit{fraction, start + ray.direction * fraction};
}

MaybeHit intersect(const Ray& ray, const Circle& circle) {
    return intersect(ray, circle.center, circle.radius);
}

/// The ray runs along the line that the segment is on.
MaybeHit intersectCollinear(const Ray& ray, const Vec2& toStart, const Vec2& toEnd) {
    const double first = toStart.dot(ray.direction), last = toEnd.dot(ray.direction);
    if (first < 0 && last < 0) return std::nullopt;
    if (!(first > 0 && last > 0)) return startsInside();
    const double fraction = std::min(first, last) / ray.direction.dot(ray.direction);
    if (fraction > 1) return std::nullopt;
    return RayHit{fraction, first < last ? Vec2(toStart - toEnd) : Vec2(toEnd - toStart)};
}

/// Is a cross product of these two vectors only a rounding error?
bool isRounding(double product, const Vec2& a, const Vec2& b) {
    constexpr double fourRoundings = 2 * std::numeric_limits<double>::epsilon();
    return std::fabs(product) <= fourRoundings * (std::fabs(a.x() * b.y()) + std::fabs(a.y() * b.x()));
}

/// Both ends on one side of the ray's line: no hit. The side of a point is the same for all segments that share it.
MaybeHit intersect(const Ray& ray, const Vec2& start, const Vec2& end) {
    const Vec2 toStart = start - ray.from, toEnd = end - ray.from, edge = end - start;
    const double sideStart = cross(ray.direction, toStart), sideEnd = cross(ray.direction, toEnd);
    if (isRounding(sideStart, ray.direction, toStart) && isRounding(sideEnd, ray.direction, toEnd))
        return intersectCollinear(ray, toStart, toEnd);
    if ((sideStart > 0 && sideEnd > 0) || (sideStart < 0 && sideEnd < 0)) return std::nullopt;
    // Computed from the point on the segment, not from that on the ray: only this is accurate where the two are almost
    // parallel.
    const double across = sideEnd - sideStart;
    const Vec2 position = toStart - edge * (sideStart / across);
    const double fraction = position.dot(ray.direction) / ray.direction.dot(ray.direction);
    if (fraction == 0) return startsInside();
    if (!(fraction > 0 && fraction <= 1)) return std::nullopt;
    return RayHit{fraction, across > 0 ? perp(edge) : Vec2(-perp(edge))};
}

MaybeHit intersect(const Ray& ray, const Segment& segment) {
    return intersect(ray, segment.start, segment.end);
}

MaybeHit intersect(const Ray& ray, const Chain& chain) {
    requireCount(chain);
    MaybeHit first;
    const std::size_t count = chain.points.size();
    for (std::size_t i = 0; i < (chain.closed ? count : count - 1); ++i) {
        const MaybeHit here = intersect(ray, chain.points[i], chain.points[i + 1 < count ? i + 1 : 0]);
        if (here && (!first || here->fraction < first->fraction)) first = here;
    }
    return first;
}

MaybeHit intersect(const Ray& ray, const Capsule& capsule) {
    const Vec2 edge = capsule.end - capsule.start;
    const double whole = edge.dot(edge);
    Vec2 normal = perp(edge) / std::sqrt(whole);
    double height = normal.dot(ray.from - capsule.start), fraction = 0;
    if (height < 0) normal = -normal;
    height = std::fabs(height);
    const bool beside = height > capsule.radius;
    if (beside) {
        const double closing = -normal.dot(ray.direction);
        if (!(closing > 0) || height - capsule.radius > closing) return std::nullopt;
        fraction = (height - capsule.radius) / closing;
    }
    const double along = edge.dot(ray.from + ray.direction * fraction - capsule.start);
    if (along < 0) return intersect(ray, capsule.start, capsule.radius);
    if (along > whole) return intersect(ray, capsule.end, capsule.radius);
    return beside ? RayHit{fraction, normal} : startsInside();
}

struct Edge {
    const Vec2& start;
    const Vec2& end;
    Vec2 direction() const { return end - start; }
    Vec2 outward() const { return -perp(direction()); }
};

Edge edgeOf(const Polygon& polygon, std::size_t i) {
    const std::size_t next = i + 1 < polygon.vertices.size() ? i + 1 : 0;
    return {polygon.vertices[i], polygon.vertices[next]};
}

/// The ray starts behind every edge offset outwards by the radius: inside, or in front of a rounded corner.
MaybeHit intersectFromWithinEdges(const Ray& ray, const Polygon& polygon) {
    bool inCore = true;
    double least = std::numeric_limits<double>::infinity();
    Vec2 nearest = polygon.vertices.front();
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
        const Edge edge = edgeOf(polygon, i);
        const Vec2 direction = edge.direction(), start = ray.from - edge.start;
        if (edge.outward().dot(start) <= 0) continue;
        inCore = false;
        const double part = std::clamp(start.dot(direction) / direction.dot(direction), 0.0, 1.0);
        const Vec2 apart = start - direction * part;
        if (apart.dot(apart) >= least) continue;
        least = apart.dot(apart);
        nearest = part < 0.5 ? edge.start : edge.end;
    }
    if (inCore || least <= polygon.radius * polygon.radius) return startsInside();
    return intersect(ray, nearest, polygon.radius);
}

MaybeHit intersect(const Ray& ray, const Polygon& polygon) {
    requireCount(polygon);
    const double radius = polygon.radius;
    double enter = -1, leave = 1;
    std::size_t entered = 0;
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
        const Vec2 outward = edgeOf(polygon, i).outward();
        const double extra = radius > 0 ? radius * std::sqrt(outward.dot(outward)) : 0.0;
        const double depth = outward.dot(polygon.vertices[i] - ray.from) + extra;
        const double outwardSpeed = outward.dot(ray.direction);
        if (depth < 0) {
            if (!(outwardSpeed < 0)) return std::nullopt;
            const double fraction = depth / outwardSpeed;
            if (fraction > enter) entered = i;
            enter = std::max(enter, fraction);
        } else if (outwardSpeed > 0) {
            leave = std::min(leave, depth / outwardSpeed);
        }
    }
    if (enter > leave) return std::nullopt;
    if (enter < 0) return radius > 0 ? intersectFromWithinEdges(ray, polygon) : startsInside();
    const Edge edge = edgeOf(polygon, entered);
    if (radius > 0) {
        const double along = edge.direction().dot(ray.from + ray.direction * enter - edge.start);
        if (along < 0) return intersect(ray, edge.start, radius);
        if (along > edge.direction().dot(edge.direction())) return intersect(ray, edge.end, radius);
    }
    return RayHit{enter, edge.outward()};
}

MaybeHit intersect(const Ray& ray, const TileMap& map) {
    MaybeHit first;
    for (const Shape& piece : piecesOf(map)) {
        const auto* segment = std::get_if<Segment>(&piece);
        const MaybeHit here = segment != nullptr ? intersect(ray, *segment) : intersect(ray, std::get<Polygon>(piece));
        if (here && (!first || here->fraction < first->fraction)) first = here;
    }
    return first;
}

/// A ray of zero length.
std::optional<CastPoint> castPoint(const Vec2& point, const Shape& shape, const Transform& pose) {
    const Distance here = distance(shape, pose, Circle{.radius = 0}, {point, {}});
    if (!(here.separation <= 0 && std::isfinite(here.separation))) return std::nullopt;
    return CastPoint{point, here.normal, 0};
}

}  // namespace

std::optional<CastPoint> castRay(const Vec2& from, const Vec2& to, const Shape& shape, const Transform& pose) {
    const Vec2 direction = to - from;
    if (!(direction.dot(direction) > 0)) return castPoint(from, shape, pose);
    const Rot back = pose.rotation.inverse();
    const Ray ray{back * Vec2(from - pose.position), back * direction};
    const MaybeHit hit = std::visit([&](const auto& outline) { return intersect(ray, outline); }, shape);
    if (!hit) return std::nullopt;
    if (hit->normal.isZero(0)) {
        // A ray that is not finite is never outside of an edge.
        const bool sound = ray.from.allFinite() && ray.direction.allFinite();
        return sound ? std::optional<CastPoint>({from, -detail::unit(direction), 0}) : std::nullopt;
    }
    const Vec2 point = from + direction * hit->fraction;
    if (!point.allFinite()) return std::nullopt;
    return CastPoint{point, pose.rotation * detail::unit(hit->normal), hit->fraction};
}

}  // namespace plumb
