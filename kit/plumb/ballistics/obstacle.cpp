// SPDX-License-Identifier: MIT
#include <plumb/ballistics/obstacle.h>

#include <algorithm>
#include <cmath>

#include <plumb/ballistics/detail/gravity_frame.h>
#include <plumb/ballistics/detail/input.h>
#include <plumb/ballistics/fixed_speed.h>
#include <plumb/ballistics/least_speed.h>

namespace plumb {
namespace {

void require(const WallAim& problem) {
    detail::requireSize(problem.target, "WallAim", ".target");
    for (const Vec2& wall : problem.walls) detail::requireSize(wall, "WallAim", ".walls");
    detail::requireAmount(problem.margin, "WallAim", ".margin");
    detail::requireAmount(problem.speed, "WallAim", ".speed");
    detail::requireSize(problem.gravity, "WallAim", ".gravity");
}

/// The problem in a frame with the target to the right, and gravity down.
class Side {
public:
    explicit Side(const WallAim& problem) : frame_(problem.gravity), margin_(problem.margin) {
        if (problem.target.dot(frame_.right) < 0) frame_.right = -frame_.right;
        target_ = local(problem.target);
    }

    double gravity() const { return frame_.gravity; }
    const Vec2& target() const { return target_; }
    /// Horizontal and vertical components.
    Vec2 local(const Vec2& v) const { return {v.dot(frame_.right), v.dot(frame_.up)}; }
    Vec2 world(const Vec2& v) const { return v.x() * frame_.right + v.y() * frame_.up; }
    bool isInTheWay(const Vec2& wall) const { return wall.x() > 0 && wall.x() < target_.x(); }

    /// The tangent of the angle of the flattest shot at the target that clears a wall; the wall is local and between
    /// muzzle and target.
    double slopeOver(const Vec2& wall) const {
        const double part = wall.x() / target_.x();
        const double rest = 1 - part;
        return ((wall.y() + margin_) / wall.x() - target_.y() / target_.x() * part) / rest;
    }

    /// Does the shot pass below the top and its margin, by more than rounding?
    bool fallsShort(const Shot& shot, const Vec2& top) const {
        const Vec2 velocity = local(shot.velocity), wall = local(top);
        if (!isInTheWay(wall)) return false;
        const double time = wall.x() / velocity.x();
        const double risen = time * velocity.y(), fallen = 0.5 * gravity() * time * time;
        const double sizes = std::fabs(risen) + fallen + std::fabs(wall.y()) + margin_;
        return risen - fallen - (wall.y() + margin_) < -1e-15 * sizes;
    }

private:
    detail::GravityFrame frame_;
    double margin_;
    Vec2 target_{0, 0};
};

}  // namespace

std::vector<Shot> aimOver(const WallAim& problem) {
    require(problem);
    const Side side(problem);
    std::vector<Shot> shots = aim({problem.target, problem.speed, problem.gravity});
    std::erase_if(shots, [&](const Shot& shot) {
        return std::any_of(problem.walls.begin(), problem.walls.end(),
                           [&](const Vec2& top) { return side.fallsShort(shot, top); });
    });
    if (!shots.empty() || problem.walls.empty()) return shots;
    // Near the least speed the angle depends on the square root of a small difference, and so of rounding.
    const std::optional<Shot> slowest = aimSlowestOver(problem);
    if (!slowest) return shots;
    const double least = detail::lengthOf(slowest->velocity);
    if (std::fabs(problem.speed - least) <= 1e-15 * least)
        shots.push_back({detail::withLength(slowest->velocity, problem.speed), slowest->time});
    return shots;
}

std::optional<Shot> aimSlowestOver(const WallAim& problem) {
    require(problem);
    std::optional<Shot> slowest = aimSlowest({problem.target, problem.gravity});
    if (!slowest) return slowest;
    const Side side(problem);
    const Vec2& target = side.target();
    const Vec2 start = side.local(slowest->velocity);
    double needed = start.y() / start.x();
    bool clears = true;
    for (const Vec2& top : problem.walls) {
        const Vec2 wall = side.local(top);
        const double slope = side.isInTheWay(wall) ? side.slopeOver(wall) : needed;
        if (!(slope > needed)) continue;
        needed = slope;
        clears = false;
    }
    if (clears) return slowest;
    const double time = std::sqrt(2 * ((target.x() * needed - target.y()) / side.gravity()));
    const double across = target.x() / time;
    if (!std::isfinite(time) || !std::isfinite(needed)) return std::nullopt;
    return Shot{side.world({across, needed * across}), time};
}

}  // namespace plumb
