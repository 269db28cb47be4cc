// SPDX-License-Identifier: MIT
#include "kit/dynamics/chain_track.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumb::test {

namespace {

Vec2 unitAt(const std::vector<Vec2>& points, std::size_t edge) {
    return (points[edge + 1] - points[edge]).normalized();
}

/// The time until a point with this speed and acceleration has gone a way of at least 0 ahead [s].
double timeAhead(double way, double speed, double acceleration) {
    const double squared = speed * speed + 2 * acceleration * way;
    if (speed > 0 && squared >= 0) return 2 * way / (speed + std::sqrt(squared));
    return speed <= 0 && acceleration > 0 ? (std::sqrt(squared) - speed) / acceleration
                                          : std::numeric_limits<double>::infinity();
}

}  // namespace

TrackPath pathOver(const std::vector<Vec2>& line, double radius) {
    TrackPath path;
    const auto add = [&path](const Vec2& point, double keep) {
        path.points.push_back(point);
        path.keeps.push_back(keep);
    };
    add(line.front() + radius * perp(unitAt(line, 0)), 0);
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
        const Vec2 before = unitAt(line, i - 1), after = unitAt(line, i);
        const double sine = cross(before, after), cosine = before.dot(after);
        const Vec2 middle = perp(Vec2((before + after).normalized()));
        if (sine >= 0) {
            add(line[i] + radius / std::sqrt(0.5 * (1 + cosine)) * middle, cosine);
            continue;
        }
        const double turn = std::atan2(sine, cosine);
        for (int k = 0; k <= 4; ++k) {
            const double angle = turn * k / 4, c = std::cos(angle), s = std::sin(angle);
            const Vec2 normal = perp(before);
            add(line[i] + radius * Vec2(c * normal.x() - s * normal.y(), s * normal.x() + c * normal.y()), 1);
        }
    }
    add(line.back() + radius * perp(unitAt(line, line.size() - 2)), 0);
    return path;
}

Vec2 placeOn(const TrackPath& path, const TrackPoint& point) {
    return path.points[point.edge] + point.way * unitAt(path.points, point.edge);
}

TrackPoint restNear(const TrackPath& path, const Vec2& place) {
    TrackPoint best;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
        const double length = (path.points[i + 1] - path.points[i]).norm();
        const double way = std::clamp((place - path.points[i]).dot(unitAt(path.points, i)), 0.0, length);
        const double distance = (placeOn(path, {i, way}) - place).norm();
        if (distance >= nearest) continue;
        nearest = distance;
        best = {i, way, 0};
    }
    return best;
}

TrackPoint slide(const TrackPath& path, TrackPoint from, double gravity, double time) {
    TrackPoint now = from;
    for (double left = time; left > 0;) {
        const Vec2 along = unitAt(path.points, now.edge);
        const double length = (path.points[now.edge + 1] - path.points[now.edge]).norm();
        const double a = -gravity * along.y(), v = now.speed;
        const double up = timeAhead(length - now.way, v, a), down = timeAhead(now.way, -v, -a);
        const double step = std::min({up, down, left});
        left -= step;
        now.way = std::clamp(now.way + (v + 0.5 * a * step) * step, 0.0, length);
        now.speed = v + a * step;
        if (left <= 0) break;
        const bool forwards = up <= down;
        now.speed *= path.keeps[forwards ? now.edge + 1 : now.edge];
        if (now.speed == 0) break;
        if (forwards)
            ++now.edge;
        else
            --now.edge;
        now.way = forwards ? 0 : (path.points[now.edge + 1] - path.points[now.edge]).norm();
    }
    return now;
}

}  // namespace plumb::test
