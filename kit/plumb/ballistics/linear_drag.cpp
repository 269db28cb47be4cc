// SPDX-License-Identifier: MIT
#include <plumb/ballistics/linear_drag.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <plumb/ballistics/detail/gravity_frame.h>
#include <plumb/ballistics/detail/input.h>
#include <plumb/kinematics/linear_drag.h>
#include <plumb/math/logarithm.h>

namespace plumb {
namespace {

void require(const Vec2& velocity, const LinearDrag& drag) {
    detail::requireSize(velocity, "linear drag: ", "velocity");
    detail::requireAmount(drag.rate, "LinearDrag", ".rate");
    detail::requireSize(drag.wind, "LinearDrag", ".wind");
    detail::requireSize(drag.gravity, "LinearDrag", ".gravity");
}

// Acceleration of a shot at rest.
Vec2 startOf(const LinearDrag& drag) {
    return drag.gravity + drag.rate * drag.wind;
}

PointMotion stateAt(const Vec2& velocity, double time, const LinearDrag& drag) {
    const DragStep step = uncheckedDragStep(drag.rate, time);
    const Vec2 a = startOf(drag);
    return {step.gain * velocity + step.reach * a, step.keep * velocity + step.gain * a};
}

std::optional<PathPoint> pointAt(const Vec2& velocity, double time, const LinearDrag& drag) {
    if (!std::isfinite(time)) return std::nullopt;
    const Vec2 position = stateAt(velocity, time, drag).position;
    if (!position.allFinite()) return std::nullopt;
    return PathPoint{position, time};
}

/// The vertical motion alone.
struct Rise {
    double speed;  ///< at the launch, upward [m/s]
    double pull;   ///< acceleration of a shot at rest, downward [m/s^2]
    double rate;

    double apexTime() const { return rate > 0 ? logarithm1Plus(rate * (speed / pull)) / rate : speed / pull; }

    /// The time at which it would reach a height below the muzzle, >= 0, without drag: not later than with drag when it
    /// does not rise, otherwise sooner or later.
    double timeWithoutDrag(double height) const {
        const double root = std::sqrt(speed * speed + 2 * std::max(pull, 0.0) * height);
        return speed > 0 ? (speed + root) / pull : 2 * height / (root - speed);
    }

    /// The time at which it reaches a height below the muzzle; infinite when it never does. The height is convex or
    /// concave in time, so that from the second step on Newton's method converges from one side. If it is convex, a
    /// step past its minimum shows that there is no zero.
    double landingTime(double height) const {
        double time = timeWithoutDrag(std::max(height, 0.0));
        for (int i = 0; i < 200; ++i) {
            const DragStep at = uncheckedDragStep(rate, time);
            const double above = at.gain * speed - at.reach * pull + height;
            const double fall = at.gain * pull - at.keep * speed;
            if (!(fall > 0)) break;
            const double step = above / fall;
            time += step;
            if (std::fabs(step) <= 1e-13 * time) return time;
        }
        return std::numeric_limits<double>::infinity();
    }
};

}  // namespace

std::optional<PathPoint> linearDragApex(const Vec2& velocity, const LinearDrag& drag) {
    require(velocity, drag);
    const detail::GravityFrame frame(drag.gravity);
    const Rise rise{velocity.dot(frame.up), -startOf(drag).dot(frame.up), drag.rate};
    if (!(rise.speed > 0 && rise.pull > 0)) return std::nullopt;
    return pointAt(velocity, rise.apexTime(), drag);
}

std::optional<PathPoint> linearDragLanding(const Vec2& velocity, double height, const LinearDrag& drag) {
    require(velocity, drag);
    detail::requireSize(height, "linear drag: ", "height");
    const detail::GravityFrame frame(drag.gravity);
    const Rise rise{velocity.dot(frame.up), -startOf(drag).dot(frame.up), drag.rate};
    if (frame.gravity == 0) return std::nullopt;
    if (rise.speed <= 0) {
        if (height < 0) return std::nullopt;
        return pointAt(velocity, height == 0 ? 0 : rise.landingTime(height), drag);
    }
    if (!(rise.pull > 0)) return std::nullopt;
    const DragStep top = uncheckedDragStep(drag.rate, rise.apexTime());
    if (top.gain * rise.speed - top.reach * rise.pull < -height) return std::nullopt;
    return pointAt(velocity, rise.landingTime(height), drag);
}

}  // namespace plumb
