// SPDX-License-Identifier: MIT
#include <plumb/movers/path_shape.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>

#include <plumb/math/check.h>
#include <plumb/math/rot.h>
#include <plumb/movers/detail/cubic_length.h>

namespace plumb {

namespace {

struct LinePiece {
    Vec2 from, direction;
    double length() const { return length_; }
    PathPlace at(double along) const { return {from + along * direction, direction}; }
    double length_;
};

struct ArcPiece {
    Vec2 center, spoke;  ///< spoke to where it begins
    double radius, angle;
    double length() const { return radius * std::fabs(angle); }
    PathPlace at(double along) const {
        const double side = angle > 0 ? 1 : -1;
        const Vec2 turned = Rot::fromAngle(side * along / radius) * spoke;
        return {center + turned, side / radius * perp(turned)};
    }
};

struct CurvePiece {
    CubicLength curve;
    double length() const { return curve.length(); }
    PathPlace at(double along) const {
        const double u = curve.parameterAt(along);
        return {curve.cubic().at(u), curve.cubic().tangent(u)};
    }
};

}  // namespace

struct MotionPath::Piece {
    std::variant<LinePiece, ArcPiece, CurvePiece> form;
    double start = 0;  ///< along the path [m]

    double length() const {
        return std::visit([](const auto& piece) { return piece.length(); }, form);
    }
    PathPlace at(double along) const {
        return std::visit([&](const auto& piece) { return piece.at(along); }, form);
    }
};

MotionPath::MotionPath(const Vec2& start) : start_(start), end_(start) {
    requireFinite(start, "MotionPath: start");
}

void MotionPath::add(Piece piece) {
    const double length = piece.length();
    requirePositive(length_ + length, "MotionPath: length");
    requirePositive(length, "MotionPath: length of a piece");
    piece.start = length_;
    const Vec2 end = piece.at(length).position;
    requireFinite(end, "MotionPath: end");
    pieces_.push_back(std::make_shared<const Piece>(std::move(piece)));
    end_ = end;
    length_ += length;
}

MotionPath& MotionPath::lineTo(const Vec2& end) {
    requireFinite(end, "MotionPath.lineTo: end");
    const Vec2 displacement = end - end_;
    const double length = displacement.norm();
    requireFinite(length, "MotionPath.lineTo: length");
    if (!(length > 0)) refuse("MotionPath.lineTo: end", toText(end) + " is where the path is already");
    add({LinePiece{end_, displacement / length, length}});
    end_ = end;
    return *this;
}

MotionPath& MotionPath::arcAround(const Vec2& center, double angle) {
    requireFinite(center, "MotionPath.arcAround: center");
    requireFinite(angle, "MotionPath.arcAround: angle");
    if (angle == 0) refuse("MotionPath.arcAround: angle", "0 is no arc");
    const Vec2 spoke = end_ - center;
    const double radius = spoke.norm();
    requireFinite(radius, "MotionPath.arcAround: radius");
    if (!(radius > 0)) refuse("MotionPath.arcAround: center", toText(center) + " is where the path is");
    add({ArcPiece{center, spoke, radius, angle}});
    return *this;
}

MotionPath& MotionPath::curveTo(const Vec2& first, const Vec2& second, const Vec2& end) {
    requireFinite(first, "MotionPath.curveTo: first");
    requireFinite(second, "MotionPath.curveTo: second");
    requireFinite(end, "MotionPath.curveTo: end");
    const Cubic cubic{{end_, first, second, end}};
    requireWithin(cubic.size(), 1e-100, 1e100, "MotionPath.curveTo: size");
    add({CurvePiece{CubicLength(cubic)}});
    end_ = end;
    return *this;
}

MotionPath& MotionPath::close() {
    return closed() ? *this : lineTo(start_);
}

bool MotionPath::closed() const {
    return length_ > 0 && (end_ - start_).norm() <= 1e-9 * length_;
}

PathPlace MotionPath::at(double along) const {
    requireFinite(along, "MotionPath.at: along");
    if (pieces_.empty()) refuse("MotionPath.at", "the path has no piece");
    along = std::clamp(along, 0.0, length_);
    const auto after = std::upper_bound(
        pieces_.begin() + 1, pieces_.end(), along,
        [](double distance, const std::shared_ptr<const Piece>& piece) { return distance < piece->start; });
    const Piece& piece = **(after - 1);
    return piece.at(std::min(along - piece.start, piece.length()));
}

namespace {

/// The points of a spline. An open one is extended by one point at either end, the mirror image of the neighbour; a
/// closed one is periodic.
class Knots {
public:
    Knots(std::span<const Vec2> points, bool closed) : points_(points), closed_(closed) {}

    /// i from -1 to the number of points.
    Vec2 at(int i) const {
        const int count = static_cast<int>(points_.size());
        if (closed_) return points_[static_cast<std::size_t>((i + count) % count)];
        if (i < 0) return 2 * points_[0] - points_[1];
        if (i >= count) return 2 * points_[points_.size() - 1] - points_[points_.size() - 2];
        return points_[static_cast<std::size_t>(i)];
    }

private:
    std::span<const Vec2> points_;
    bool closed_;
};

/// The square root of the distance: this makes the spline centripetal.
double knotStep(const Vec2& a, const Vec2& b) {
    return std::sqrt((b - a).norm());
}

/// The derivative of the curve at b, from the knot intervals to a and c.
Vec2 slopeAt(const Vec2& a, const Vec2& b, const Vec2& c) {
    const double before = knotStep(a, b), after = knotStep(b, c);
    return (b - a) / before + (c - b) / after - (c - a) / (before + after);
}

void requireApart(std::span<const Vec2> points, bool closed) {
    const std::size_t least = closed ? 3 : 2;
    if (points.size() < least)
        refuse("splineThrough: points",
               std::to_string(points.size()) + " points are fewer than " + std::to_string(least));
    if (points.size() > (1u << 24)) refuse("splineThrough: points", "more than 2^24");
    for (const Vec2& point : points) requireFinite(point, "splineThrough: points");
    for (std::size_t i = 0; i + (closed ? 0 : 1) < points.size(); ++i) {
        const std::size_t next = (i + 1) % points.size();
        const double distance = (points[next] - points[i]).norm();
        requireFinite(distance, "splineThrough: points, their distance");
        if (!(distance > 0))
            refuse("splineThrough: points[" + std::to_string(next) + "]",
                   toText(points[next]) + " is where its neighbour is");
    }
}

}  // namespace

MotionPath splineThrough(std::span<const Vec2> points, bool closed) {
    requireApart(points, closed);
    const Knots knots(points, closed);
    MotionPath path(points[0]);
    const int curves = static_cast<int>(points.size()) - (closed ? 0 : 1);
    for (int i = 0; i < curves; ++i) {
        const Vec2 before = knots.at(i - 1), from = knots.at(i), to = knots.at(i + 1);
        const Vec2 after = knots.at(closed ? (i + 2) % static_cast<int>(points.size()) : i + 2);
        const double third = knotStep(from, to) / 3;
        path.curveTo(from + third * slopeAt(before, from, to), to - third * slopeAt(from, to, after), to);
    }
    return path;
}

MotionPath splineThrough(std::initializer_list<Vec2> points, bool closed) {
    return splineThrough(std::span(points.begin(), points.size()), closed);
}

}  // namespace plumb
