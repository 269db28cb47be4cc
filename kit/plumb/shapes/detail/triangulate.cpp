// SPDX-License-Identifier: MIT
#include <plumb/shapes/detail/point_sets.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace plumb {
namespace {

/// Twice the area of a triangle, positive when it runs counter-clockwise.
double area(const Vec2& a, const Vec2& b, const Vec2& c) {
    return cross(Vec2(b - a), Vec2(c - a));
}

/// How far a triangle is from degenerate: its smallest height over its longest side; negative when it is clockwise.
double thickness(const Vec2& a, const Vec2& b, const Vec2& c) {
    const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    return area(a, b, c) / longest;
}

/// The remaining polygon, and the quality of each of its corners as an ear.
class EarClipping {
public:
    explicit EarClipping(std::span<const Vec2> corners) : corners_(corners) {
        for (std::size_t i = 0; i < corners.size(); ++i) left_.push_back(i);
        for (std::size_t at = 0; at < left_.size(); ++at) quality_.push_back(qualityOf(at));
    }

    std::vector<Triangle> run() {
        std::vector<Triangle> triangles;
        while (left_.size() > 3) {
            const auto best = std::max_element(quality_.begin(), quality_.end());
            std::size_t at = static_cast<std::size_t>(best - quality_.begin());
            triangles.push_back({left_[before(at)], left_[at], left_[after(at)]});
            left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(at));
            quality_.erase(best);
            at = at < left_.size() ? at : 0;
            quality_[at] = qualityOf(at);
            quality_[before(at)] = qualityOf(before(at));
        }
        triangles.push_back({left_[0], left_[1], left_[2]});
        return triangles;
    }

private:
    std::size_t before(std::size_t at) const { return (at > 0 ? at : left_.size()) - 1; }
    std::size_t after(std::size_t at) const { return at + 1 < left_.size() ? at + 1 : 0; }

    /// Less than -1 for a corner that is not an ear: it is taken only if rounding leaves no other.
    double qualityOf(std::size_t at) const {
        const Vec2& a = corners_[left_[before(at)]];
        const Vec2& b = corners_[left_[at]];
        const Vec2& c = corners_[left_[after(at)]];
        const double thick = thickness(a, b, c);
        if (!(thick > 0)) return thick - 2;
        const auto isWithin = [&](std::size_t i) {
            const Vec2& p = corners_[i];
            return area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= -tolerance;
        };
        for (std::size_t i = 0; i < left_.size(); ++i)
            if (i != at && i != before(at) && i != after(at) && isWithin(left_[i])) return thick - 4;
        return thick;
    }

    /// Points on the new edge of the polygon count as inside the ear, despite rounding.
    static constexpr double tolerance = 1e-14;

    std::span<const Vec2> corners_;
    std::vector<std::size_t> left_;
    std::vector<double> quality_;
};

/// Triangles, and a map from each edge to its triangle.
class EdgeFlipper {
public:
    EdgeFlipper(std::span<const Vec2> corners, std::vector<Triangle> triangles)
        : corners_(corners), triangles_(std::move(triangles)) {
        for (std::size_t i = 0; i < triangles_.size(); ++i) addSides(i);
    }

    /// Each flip makes the smallest angles larger, so that this ends; the limit guards against rounding.
    std::vector<Triangle> run() {
        bool flipped = true;
        for (std::size_t pass = 0; flipped && pass < corners_.size() + 8; ++pass) {
            flipped = false;
            for (std::size_t i = 0; i < triangles_.size(); ++i)
                for (std::size_t side = 0; side < 3; ++side) flipped = flip(i, side) || flipped;
        }
        return triangles_;
    }

private:
    using Side = std::pair<std::size_t, std::size_t>;

    void addSides(std::size_t i) {
        const Triangle& t = triangles_[i];
        for (std::size_t side = 0; side < 3; ++side) owner_[{t[side], t[(side + 1) % 3]}] = i;
    }

    bool flip(std::size_t i, std::size_t side) {
        const Triangle here = triangles_[i];
        const std::size_t from = here[side], to = here[(side + 1) % 3], apex = here[(side + 2) % 3];
        const auto other = owner_.find({to, from});
        if (other == owner_.end()) return false;
        const std::size_t j = other->second;
        const Triangle there = triangles_[j];
        std::size_t opposite = 0;
        for (const std::size_t corner : there)
            if (corner != from && corner != to) opposite = corner;
        const Vec2 &a = corners_[from], &b = corners_[to], &c = corners_[apex], &d = corners_[opposite];
        if (!isBetterFlipped(a, b, c, d)) return false;
        owner_.erase({from, to});
        owner_.erase({to, from});
        triangles_[i] = {apex, from, opposite};
        triangles_[j] = {opposite, to, apex};
        addSides(i);
        addSides(j);
        return true;
    }

    /// By the sine of the sum of the angles at c and d, opposite to the diagonal from a to b.
    static bool isBetterFlipped(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
        if (!(area(c, a, d) > 0 && area(d, b, c) > 0)) return false;
        const Vec2 ca = a - c, cb = b - c, da = a - d, db = b - d;
        const double sine = cross(ca, cb) * da.dot(db) + ca.dot(cb) * cross(db, da);
        const double lengths = std::sqrt(ca.squaredNorm() * cb.squaredNorm() * da.squaredNorm() * db.squaredNorm());
        return sine < -1e-12 * lengths;
    }

    std::span<const Vec2> corners_;
    std::vector<Triangle> triangles_;
    std::map<Side, std::size_t> owner_;
};

}  // namespace

std::vector<Triangle> triangulate(std::span<const Vec2> corners) {
    return EdgeFlipper(corners, EarClipping(corners).run()).run();
}

}  // namespace plumb
