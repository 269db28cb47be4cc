// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/sweep.h>

#include <algorithm>
#include <cmath>

#include <plumb/collide/distance.h>

namespace plumb {

namespace {

/// So much nearer counts as there already: what saves the last of ever smaller steps [m].
constexpr double early = 1e-5;

/// A search with more steps than this goes no further. One at a rod that turns three times takes some hundred.
constexpr int mostSteps = 500;

}  // namespace

Transform poseOn(const Way& way, double time) {
    const Rot rotation = Rot::fromAngle(way.angle + way.turn * time);
    return {way.start + way.shift * time - rotation * way.localCenter, rotation};
}

std::optional<double> timeWithin(const SweptShape& a, const SweptShape& b, double limit, double from) {
    const Vec2 shift = b.way.shift - a.way.shift;
    const Vec2 between = b.way.start - a.way.start;
    const double farthest = std::max(between.norm(), (between + shift).norm());
    const double turning = std::fabs(b.way.turn - a.way.turn) * b.reach;
    const double bend = std::fabs(a.way.turn) * (2 * shift.norm() + std::fabs(a.way.turn) * farthest);
    double time = from;
    for (int i = 0; i < mostSteps; ++i) {
        const Distance now = distance(*a.shape, poseOn(a.way, time), *b.shape, poseOn(b.way, time));
        const double room = now.separation - limit;
        if (room <= early) return time;
        const Vec2 apart = between + shift * time;
        const double closing = (perp(apart) * a.way.turn - shift).dot(now.normal) + turning;
        const double fastest = closing + std::sqrt(closing * closing + 2 * bend * room);
        if (!(fastest * (1 - time) > 2 * room)) return std::nullopt;
        time += 2 * room / fastest;
    }
    return time;
}

}  // namespace plumb
