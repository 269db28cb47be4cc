// SPDX-License-Identifier: MIT
// The shots of constant gravity, each of which has a closed form: by speed, by angle, by time, by apex, and the
// slowest; and the shot in a straight line.
#include <cmath>

#include <plumb/ballistics/apex.h>
#include <plumb/ballistics/beam.h>
#include <plumb/ballistics/detail/gravity_frame.h>
#include <plumb/ballistics/detail/input.h>
#include <plumb/ballistics/detail/straight_intercepts.h>
#include <plumb/ballistics/fixed_angle.h>
#include <plumb/ballistics/fixed_speed.h>
#include <plumb/ballistics/fixed_time.h>
#include <plumb/ballistics/least_speed.h>
#include <plumb/math/trig.h>

namespace plumb {

std::vector<Shot> aim(const Aim& problem) {
    detail::requireSize(problem.target, "Aim", ".target");
    detail::requireAmount(problem.speed, "Aim", ".speed");
    detail::requireSize(problem.gravity, "Aim", ".gravity");

    const Vec2& d = problem.target;
    const Vec2& g = problem.gravity;
    const double v = problem.speed;
    const double distance = detail::lengthOf(d);
    if (distance <= detail::muzzle) return {{v * detail::GravityFrame(g).up, 0}};
    const double gravity = detail::lengthOf(g);
    const double least = detail::leastSpeedSquared(d, distance, g, gravity);
    double spare = v * v - least;
    if (std::fabs(spare) <= 2e-15 * least) spare = 0;
    if (spare < 0) return {};

    const double b = v * v + g.dot(d);
    const double sum = b + std::sqrt(spare) * std::sqrt(b + gravity * distance);  // B + S
    std::vector<Shot> shots;
    const auto add = [&](double t) {
        if (std::isfinite(t)) shots.push_back({detail::withLength(d / t - 0.5 * t * g, v), t});
    };
    if (sum > 0) add(distance * std::sqrt(2 / sum));
    if (spare > 0 && gravity > 0) add(std::sqrt(2 * sum) / gravity);
    return shots;
}

std::optional<Shot> aimSlowest(const SlowestAim& problem) {
    detail::requireSize(problem.target, "SlowestAim", ".target");
    detail::requireSize(problem.gravity, "SlowestAim", ".gravity");

    const Vec2& d = problem.target;
    const Vec2& g = problem.gravity;
    const double distance = detail::lengthOf(d);
    const double gravity = detail::lengthOf(g);
    if (distance == 0) return Shot{};
    const double time = std::sqrt(2 * (distance / gravity));
    if (!(time > 0 && std::isfinite(time))) return std::nullopt;
    const double speed = std::sqrt(detail::leastSpeedSquared(d, distance, g, gravity));
    return Shot{detail::withLength(d / time - 0.5 * time * g, speed), time};
}

std::optional<Shot> aimAtAngle(const AngleAim& problem) {
    detail::requireSize(problem.target, "AngleAim", ".target");
    detail::requireSize(problem.angle, "AngleAim", ".angle");
    detail::requireSize(problem.gravity, "AngleAim", ".gravity");

    const SinCos turn = sinCos(problem.angle);
    const Vec2 n(turn.cos, turn.sin);
    const double fall = cross(n, problem.gravity);
    const double time = std::sqrt(2 * (cross(n, problem.target) / fall));
    const double speed = cross(problem.target, problem.gravity) / (time * fall);
    // Infinite or NaN when the barrel points along gravity, straight at the target, or above the possible angles.
    if (!(speed > 0 && std::isfinite(speed) && std::isfinite(time))) return std::nullopt;
    return Shot{speed * n, time};
}

Shot aimInTime(const TimeAim& problem) {
    detail::requireSize(problem.target, "TimeAim", ".target");
    detail::requirePositiveAmount(problem.time, "TimeAim", ".time");
    detail::requireSize(problem.gravity, "TimeAim", ".gravity");
    return {problem.target / problem.time - 0.5 * problem.time * problem.gravity, problem.time};
}

std::optional<Shot> aimByApex(const ApexAim& problem) {
    detail::requireSize(problem.target, "ApexAim", ".target");
    detail::requireAmount(problem.apex, "ApexAim", ".apex");
    detail::requireSize(problem.gravity, "ApexAim", ".gravity");

    const detail::GravityFrame frame(problem.gravity);
    const double up = problem.target.dot(frame.up);
    const double along = problem.target.dot(frame.right);
    if (!(frame.gravity > 0) || up > problem.apex) return std::nullopt;
    const double time =
        std::sqrt(2 * (problem.apex / frame.gravity)) + std::sqrt(2 * ((problem.apex - up) / frame.gravity));
    const double drift = along == 0 ? 0 : along / time;
    if (!std::isfinite(time) || !std::isfinite(drift)) return std::nullopt;
    return Shot{drift * frame.right + std::sqrt(2 * frame.gravity * problem.apex) * frame.up, time};
}

std::optional<Shot> aimBeam(const BeamAim& problem) {
    detail::requireSize(problem.target, "BeamAim", ".target");
    detail::requireSize(problem.targetVelocity, "BeamAim", ".targetVelocity");
    detail::requireSize(problem.shooterVelocity, "BeamAim", ".shooterVelocity");
    detail::requireAmount(problem.speed, "BeamAim", ".speed");

    const double v = problem.speed;
    if (detail::lengthOf(problem.target) <= detail::muzzle) return Shot{Vec2(v, 0) + problem.shooterVelocity, 0};
    const Vec2 w = problem.targetVelocity - problem.shooterVelocity;
    const detail::Intercepts found = detail::straightIntercepts(problem.target, w, v);
    if (found.count == 0) return std::nullopt;
    const detail::Intercepts::Intercept& first = found.intercepts[0];
    const Vec2 velocity = first.closing * detail::directionOf(problem.target) + w;
    return Shot{detail::withLength(velocity, v) + problem.shooterVelocity, first.time};
}

}  // namespace plumb
