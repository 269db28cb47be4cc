// SPDX-License-Identifier: MIT
#include <plumb/shapes/oriented_box.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <plumb/math/check.h>
#include <plumb/shapes/detail/point_sets.h>

namespace plumb {
namespace {

/// Rotating calipers: the hull of some points, and which of its corners is farthest on each side of an edge.
class Calipers {
public:
    explicit Calipers(std::span<const Vec2> points) {
        for (const std::size_t index : hullOutline(points)) corners_.push_back(points[index]);
    }

    /// The direction of the edge along which the smallest box lies, with the diameter of the rounding added to both
    /// sides.
    Vec2 bestDirection(double diameter) {
        Vec2 best(1, 0);
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < corners_.size(); ++i) {
            const Vec2 edge = edgeFrom(i);
            const double length = edge.norm();
            if (!(length > 0 && std::isfinite(length))) continue;
            const Vec2 along = edge / length;
            const Vec2 size = sizeAlong(i, along);
            const double area = (size.x() + diameter) * (size.y() + diameter);
            if (area < least) {
                least = area;
                best = along;
            }
        }
        return best;
    }

private:
    std::size_t after(std::size_t i) const { return i + 1 < corners_.size() ? i + 1 : 0; }
    Vec2 edgeFrom(std::size_t i) const { return corners_[after(i)] - corners_[i]; }

    /// Advances from an earlier corner to the one that is farthest along a direction; at most once around, in case of
    /// rounding errors.
    std::size_t farthestFrom(std::size_t corner, const Vec2& direction) const {
        for (std::size_t i = 0; i < corners_.size() && direction.dot(edgeFrom(corner)) > 0; ++i) corner = after(corner);
        return corner;
    }

    /// Width and height of the box along edge i; call it for one edge after the other.
    Vec2 sizeAlong(std::size_t i, const Vec2& along) {
        if (!started_) right_ = top_ = left_ = after(i);
        right_ = farthestFrom(right_, along);
        top_ = farthestFrom(started_ ? top_ : right_, perp(along));
        left_ = farthestFrom(started_ ? left_ : top_, -along);
        started_ = true;
        return {along.dot(corners_[right_] - corners_[left_]), perp(along).dot(corners_[top_] - corners_[i])};
    }

    std::vector<Vec2> corners_;
    std::size_t right_ = 0, top_ = 0, left_ = 0;
    bool started_ = false;
};

OrientedBox boxAround(std::span<const Vec2> points, double radius) {
    for (std::size_t i = 0; i < points.size(); ++i)
        if (!points[i].allFinite()) requireFinite(points[i], "orientedBoxOf.points[" + std::to_string(i) + "]");
    if (points.empty()) refuse("orientedBoxOf.points", "there are none");
    std::vector<Vec2> fromFirst;
    for (const Vec2& point : points) fromFirst.push_back(point - points.front());
    const Vec2 along = Calipers(fromFirst).bestDirection(2 * radius);
    Vec2 lower(0, 0), upper(0, 0);  // in the box's axes, relative to the first point
    for (const Vec2& from : fromFirst) {
        const Vec2 position(along.dot(from), perp(along).dot(from));
        lower = lower.cwiseMin(position);
        upper = upper.cwiseMax(position);
    }
    const Rot rotation{along.x(), along.y()};
    const Vec2 middle = 0.5 * lower + 0.5 * upper;
    return {points.front() + rotation * middle, 0.5 * upper - 0.5 * lower + Vec2::Constant(radius), rotation};
}

}  // namespace

OrientedBox orientedBoxOf(const Shape& shape, const Transform& pose) {
    validate(shape, "orientedBoxOf.shape");
    CorePoints core = corePointsOf(shape);
    for (Vec2& point : core.points) point = pose * point;
    return boxAround(core.points, core.radius);
}

OrientedBox orientedBoxOf(std::span<const Vec2> points) {
    return boxAround(points, 0);
}

std::array<Vec2, 4> cornersOf(const OrientedBox& box) {
    const auto at = [&](double x, double y) {
        return Vec2(box.center + box.rotation * box.halfSize.cwiseProduct(Vec2(x, y)));
    };
    return {at(-1, -1), at(1, -1), at(1, 1), at(-1, 1)};
}

bool overlap(const OrientedBox& a, const OrientedBox& b) {
    const Vec2 between = b.center - a.center;
    const Vec2 inA = a.rotation.inverse() * between, inB = b.rotation.inverse() * between;
    const Rot turn = a.rotation.inverse() * b.rotation;
    const double cos = std::fabs(turn.cos), sin = std::fabs(turn.sin);
    const Vec2& sizeA = a.halfSize;
    const Vec2& sizeB = b.halfSize;
    return std::fabs(inA.x()) <= sizeA.x() + sizeB.x() * cos + sizeB.y() * sin &&
           std::fabs(inA.y()) <= sizeA.y() + sizeB.x() * sin + sizeB.y() * cos &&
           std::fabs(inB.x()) <= sizeB.x() + sizeA.x() * cos + sizeA.y() * sin &&
           std::fabs(inB.y()) <= sizeB.y() + sizeA.x() * sin + sizeA.y() * cos;
}

bool contains(const OrientedBox& box, const Vec2& point) {
    const Vec2 local = box.rotation.inverse() * Vec2(point - box.center);
    return std::fabs(local.x()) <= box.halfSize.x() && std::fabs(local.y()) <= box.halfSize.y();
}

}  // namespace plumb
