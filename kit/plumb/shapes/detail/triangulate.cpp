// SPDX-License-Identifier: MIT
#include <plumb/shapes/detail/triangulate.h>

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

/// How far from a line a triangle is: its least height over its longest side; negative when it runs clockwise.
double thickness(const Vec2& a, const Vec2& b, const Vec2& c) {
    const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    return area(a, b, c) / longest;
}

/// What is left of the polygon, and how good each of its corners is as an ear.
class EarClipping {
public:
    explicit EarClipping(std::span<const Vec2> corners) : corners_(corners) {
        for (std::size_t i = 0; i < corners.size(); ++i) left_.push_back(i);
        for (std::size_t at = 0; at < left_.size(); ++at) worth_.push_back(worthOf(at));
    }

    std::vector<Triangle> run() {
        std::vector<Triangle> triangles;
        while (left_.size() > 3) {
            const auto best = std::max_element(worth_.begin(), worth_.end());
            std::size_t at = static_cast<std::size_t>(best - worth_.begin());
            triangles.push_back({left_[before(at)], left_[at], left_[after(at)]});
            left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(at));
            worth_.erase(best);
            at = at < left_.size() ? at : 0;
            worth_[at] = worthOf(at);
            worth_[before(at)] = worthOf(before(at));
        }
        triangles.push_back({left_[0], left_[1], left_[2]});
        return triangles;
    }

private:
    std::size_t before(std::size_t at) const { return (at > 0 ? at : left_.size()) - 1; }
    std::size_t after(std::size_t at) const { return at + 1 < left_.size() ? at + 1 : 0; }

    /// Less than -1 where it is none: then only when rounding leaves nothing else is it taken.
    double worthOf(std::size_t at) const {
        const Vec2& a = corners_[left_[before(at)]];
        const Vec2& b = corners_[left_[at]];
        const Vec2& c = corners_[left_[after(at)]];
        const double thick = thickness(a, b, c);
        if (!(thick > 0)) return thick - 2;
        const auto isWithin = [&](std::size_t i) {
            const Vec2& p = corners_[i];
            return area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= -nothing;
        };
        for (std::size_t i = 0; i < left_.size(); ++i)
            if (i != at && i != before(at) && i != after(at) && isWithin(left_[i])) return thick - 4;
        return thick;
    }

    /// What lies on the new side of the polygon is in the way, too, whatever rounding says.
    static constexpr double nothing = 1e-14;

    std::span<const Vec2> corners_;
    std::vector<std::size_t> left_;
    std::vector<double> worth_;
};

/// Triangles, and on which one each side is.
class Flipping {
public:
    Flipping(std::span<const Vec2> corners, std::vector<Triangle> triangles)
        : corners_(corners), triangles_(std::move(triangles)) {
        for (std::size_t i = 0; i < triangles_.size(); ++i) note(i);
    }

    /// Each turn makes the least angles larger, so that this comes to an end; the count guards against roundings.
    std::vector<Triangle> run() {
        bool turned = true;
        for (std::size_t round = 0; turned && round < corners_.size() + 8; ++round) {
            turned = false;
            for (std::size_t i = 0; i < triangles_.size(); ++i)
                for (std::size_t side = 0; side < 3; ++side) turned = turn(i, side) || turned;
        }
        return triangles_;
    }

private:
    using Side = std::pair<std::size_t, std::size_t>;

    void note(std::size_t i) {
        const Triangle& t = triangles_[i];
        for (std::size_t side = 0; side < 3; ++side) owner_[{t[side], t[(side + 1) % 3]}] = i;
    }

    bool turn(std::size_t i, std::size_t side) {
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
        if (!isBetterTurned(a, b, c, d)) return false;
        owner_.erase({from, to});
        owner_.erase({to, from});
        triangles_[i] = {apex, from, opposite};
        triangles_[j] = {opposite, to, apex};
        note(i);
        note(j);
        return true;
    }

    /// The sine of the sum of the angles at c and d, which see the diagonal from a to b.
    static bool isBetterTurned(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
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
    return Flipping(corners, EarClipping(corners).run()).run();
}

}  // namespace plumb
