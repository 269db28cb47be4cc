// SPDX-License-Identifier: MIT
#include <plumb/ballistics/range.h>

#include <cmath>

#include <plumb/ballistics/detail/gravity_frame.h>
#include <plumb/ballistics/detail/input.h>

namespace plumb {
namespace {

void require(const Launch& launch) {
    detail::requireSize(launch.velocity, "Launch", ".velocity");
    detail::requireSize(launch.height, "Launch", ".height");
    detail::requireSize(launch.gravity, "Launch", ".gravity");
}

std::optional<PathPoint> pointAt(const Launch& launch, double time) {
    const Vec2 position = time * (launch.velocity + 0.5 * time * launch.gravity);
    if (!std::isfinite(time) || !position.allFinite()) return std::nullopt;
    return PathPoint{position, time};
}

}  // namespace

std::optional<PathPoint> apexOf(const Launch& launch) {
    require(launch);
    const detail::GravityFrame frame(launch.gravity);
    const double rise = launch.velocity.dot(frame.up);
    if (!(rise > 0)) return std::nullopt;
    return pointAt(launch, rise / frame.gravity);
}

std::optional<PathPoint> landingOf(const Launch& launch) {
    require(launch);
    const detail::GravityFrame frame(launch.gravity);
    const double rise = launch.velocity.dot(frame.up);
    const double square = rise * rise + 2 * frame.gravity * launch.height;
    if (!(frame.gravity > 0) || square < 0 || (rise <= 0 && launch.height < 0)) return std::nullopt;
    const double root = std::sqrt(square);
    if (rise > 0) return pointAt(launch, (rise + root) / frame.gravity);
    return pointAt(launch, launch.height == 0 ? 0 : 2 * launch.height / (root - rise));
}

std::optional<GreatestRange> greatestRange(const RangeAim& problem) {
    detail::requireAmount(problem.speed, "RangeAim", ".speed");
    detail::requireSize(problem.height, "RangeAim", ".height");
    detail::requireSize(problem.gravity, "RangeAim", ".gravity");

    const detail::GravityFrame frame(problem.gravity);
    const double v = problem.speed;
    const double square = v * v + 2 * frame.gravity * problem.height;
    if (!(frame.gravity > 0) || square < 0) return std::nullopt;
    const double landing = std::sqrt(square);  // the speed there
    const double both = std::sqrt(v * v + square);
    const Vec2 direction = both > 0 ? Vec2((landing * frame.right + v * frame.up) / both) : frame.right;
    const GreatestRange result{v * (landing / frame.gravity), {v * direction, both / frame.gravity}};
    if (!std::isfinite(result.range) || !std::isfinite(result.shot.time)) return std::nullopt;
    return result;
}

}  // namespace plumb
