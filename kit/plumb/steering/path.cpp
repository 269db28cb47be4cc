// SPDX-License-Identifier: MIT
#include <plumb/steering/path.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <plumb/math/check.h>
#include <plumb/math/detail/length.h>
#include <plumb/steering/seek.h>

namespace plumb {
namespace {

std::size_t edgesOf(const Path& path) {
    return path.points.size() - (path.closed ? 0 : 1);
}

/// The edge from point i of the path to the next.
Vec2 edgeOf(const Path& path, std::size_t i) {
    return path.points[(i + 1) % path.points.size()] - path.points[i];
}

/// The length of the completed rounds before a given distance along a closed path.
double roundsBefore(const Path& path, double along, double length) {
    return path.closed ? std::floor(along / length) * length : 0;
}

struct NearestPoint {
    double along, squaredDistance;
};

/// The point of an edge that is nearest to p, restricted to the range from low to high along the path; the edge begins
/// at start.
NearestPoint nearestOnEdge(const Vec2& p, const Vec2& from, const Vec2& edge, double start, double low, double high) {
    const double length = edge.norm();
    const double wanted = length > 0 ? (p - from).dot(edge) / length : 0;
    // An edge that ends at low may be shorter than low - start by rounding.
    const double least = std::min(std::max(0.0, low - start), length);
    const double along = std::clamp(wanted, least, std::min(length, high - start));
    const Vec2 point = length > 0 ? Vec2(from + edge * (along / length)) : from;
    return {start + along, (p - point).squaredNorm()};
}

/// The distance along the path of its point nearest to p, in the range from progress to progress + reach.
double nearestAhead(const Path& path, const Vec2& p, double progress, double reach, double length) {
    NearestPoint best{progress, std::numeric_limits<double>::infinity()};
    double start = roundsBefore(path, progress, length);
    const double end = progress + reach;
    const int rounds = path.closed ? 2 : 1;  // the range is at most one round long and begins in the first
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t i = 0; i < edgesOf(path); ++i) {
            const Vec2 edge = edgeOf(path, i);
            const double edgeEnd = start + edge.norm();
            if (edgeEnd >= progress && start <= end) {
                const NearestPoint here = nearestOnEdge(p, path.points[i], edge, start, progress, end);
                if (here.squaredDistance < best.squaredDistance) best = here;
            }
            start = edgeEnd;
        }
    }
    return best.along;
}

Vec2 pointAt(const Path& path, double along, double length) {
    double left = along - roundsBefore(path, along, length);
    for (std::size_t i = 0; i < edgesOf(path); ++i) {
        const Vec2 edge = edgeOf(path, i);
        const double size = edge.norm();
        if (left < size) return path.points[i] + edge * (std::max(0.0, left) / size);
        left -= size;
    }
    return path.closed ? path.points.front() : path.points.back();
}

void requireSound(const Path& path) {
    if (path.points.size() < 2) refuse("Path.points", std::to_string(path.points.size()) + " points, not two or more");
    for (const Vec2& point : path.points) requireFinite(point, "Path.points");
}

}  // namespace

double lengthOf(const Path& path) {
    requireSound(path);
    double length = 0;
    for (std::size_t i = 0; i < edgesOf(path); ++i) length += edgeOf(path, i).norm();
    return length;
}

Vec2 pointOn(const Path& path, double along) {
    const double length = lengthOf(path);
    requirePositive(length, "Path.points: length");
    requireFinite(along, "pointOn: along");
    return pointAt(path, along, length);
}

PathStep followPath(const Agent& agent, const Path& path, double progress, double ahead) {
    validate(agent);
    requireNotNegative(progress, "followPath: progress");
    requirePositive(ahead, "followPath: ahead");
    const double length = lengthOf(path);
    requirePositive(length, "Path.points: length");
    const double here = nearestAhead(path, agent.position, progress, std::min(ahead, length), length);
    const double there = here + ahead;
    if (!path.closed && there >= length) return {arrive(agent, path.points.back()), std::min(here, length)};
    const Vec2 direction = detail::directionOf(pointAt(path, there, length) - agent.position);
    // As slow as arrive would be, so that it can stop at the end.
    const double slow = path.closed ? 1 : std::min(1.0, (length - here) / slowingDistanceOf(agent));
    return {steerTo(agent, slow * agent.maxSpeed * direction), here};
}

}  // namespace plumb
