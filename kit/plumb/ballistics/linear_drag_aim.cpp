// SPDX-License-Identifier: MIT
#include <plumb/ballistics/linear_drag_aim.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <plumb/ballistics/detail/gravity_frame.h>
#include <plumb/ballistics/detail/input.h>
#include <plumb/kinematics/linear_drag.h>

namespace plumb {
namespace {

void require(const LinearDrag& drag) {
    detail::requireAmount(drag.rate, "LinearDrag", ".rate");
    detail::requireSize(drag.wind, "LinearDrag", ".wind");
    detail::requireSize(drag.gravity, "LinearDrag", ".gravity");
}

/// The circle on which all shots of one speed are at a time, and the target.
class Circle {
public:
    explicit Circle(const LinearDragAim& problem)
        : target_(problem.target),
          start_(problem.drag.gravity + problem.drag.rate * problem.drag.wind),
          speed_(problem.speed),
          rate_(problem.drag.rate),
          distance_(detail::lengthOf(target_)),
          pull_(detail::lengthOf(start_)) {}

    struct At {
        double gap;    ///< distance of the target from the circle, positive outside; 0 if only rounding [m]
        double slope;  ///< derivative of the gap with respect to reach [1/s^2 m]
        DragStep step;
    };
    At at(double time) const {
        const DragStep step = uncheckedDragStep(rate_, time);
        const Vec2 away = target_ - step.reach * start_;
        const double distance = detail::lengthOf(away);
        const double radius = speed_ * step.gain;
        const double gap = distance - radius;
        const double parts = distance_ + pull_ * step.reach + radius;
        const double towards = distance > 0 ? start_.dot(away) / distance : 0;
        return {std::fabs(gap) <= 1e-15 * parts ? 0 : gap, -towards - speed_ * step.keep / step.gain, step};
    }

    /// No shot can arrive before: this is the time without drag, with the whole pull, straight at the target.
    double soonest() const { return 2 * distance_ / (speed_ + std::sqrt(speed_ * speed_ + 2 * pull_ * distance_)); }
    /// No shot can arrive later: the circle's centre is too far away then, as the radius is below speed sqrt(2 reach)
    /// and below speed / rate.
    double latest() const {
        const double root = (speed_ + std::sqrt(speed_ * speed_ + 2 * pull_ * distance_)) / pull_;
        double reach = 0.5 * root * root;
        if (rate_ > 0) reach = std::min(reach, (distance_ + speed_ / rate_) / pull_);
        const double half = 0.5 * rate_ * reach;
        return 1.001 * (half + std::sqrt(half * half + 2 * reach));  // reach >= t^2 / (2 + rate t)
    }

    /// The zero of the gap nearest to a time outside of it, in the direction in which the gap decreases.
    std::optional<double> zeroFrom(double time, bool forward) const {
        for (int i = 0; i < 200; ++i) {
            const At now = at(time);
            if (now.gap <= 0) return time;
            if (forward ? !(now.slope < 0) : !(now.slope > 0)) return std::nullopt;
            // The time in which reach changes by so much, or a little less: reach is at most its parabola here.
            const double change = -now.gap / now.slope;
            const double gain = now.step.gain;
            const double root = std::sqrt(std::max(0.0, gain * gain + 2 * now.step.keep * change));
            const double next = time + 2 * change / (gain + root);
            if (!std::isfinite(next)) return std::nullopt;
            if (std::fabs(next - time) <= 1e-16 * time) return next;
            time = next;
        }
        return std::nullopt;
    }

    Shot shotAt(double time) const {
        const DragStep step = uncheckedDragStep(rate_, time);
        return {detail::withLength(target_ - step.reach * start_, speed_), time};
    }

private:
    Vec2 target_, start_;
    double speed_, rate_, distance_, pull_;
};

}  // namespace

std::vector<Shot> aimThroughLinearDrag(const LinearDragAim& problem) {
    detail::requireSize(problem.target, "LinearDragAim", ".target");
    detail::requireAmount(problem.speed, "LinearDragAim", ".speed");
    require(problem.drag);
    if (detail::lengthOf(problem.target) <= detail::muzzle)
        return {{problem.speed * detail::GravityFrame(problem.drag.gravity).up, 0}};

    const Circle circle(problem);
    std::vector<Shot> shots;
    const auto add = [&](double time) {
        const Shot shot = circle.shotAt(time);
        if (std::isfinite(time) && shot.velocity.allFinite()) shots.push_back(shot);
    };
    const std::optional<double> first = circle.zeroFrom(circle.soonest(), true);
    if (!first) return shots;
    const std::optional<double> last = circle.zeroFrom(circle.latest(), false);
    if (!last || !(*last > *first)) {
        add(*first);
    } else if (const double between = 0.5 * (*first + *last); circle.at(between).gap == 0) {
        add(between);  // both were found where the gap is no more than rounding, and so is it between them
    } else {
        add(*first);
        add(*last);
    }
    return shots;
}

Shot aimThroughLinearDragInTime(const LinearDragTimeAim& problem) {
    detail::requireSize(problem.target, "LinearDragTimeAim", ".target");
    detail::requirePositiveAmount(problem.time, "LinearDragTimeAim", ".time");
    require(problem.drag);
    const DragStep step = uncheckedDragStep(problem.drag.rate, problem.time);
    const Vec2 start = problem.drag.gravity + problem.drag.rate * problem.drag.wind;
    return {(problem.target - step.reach * start) / step.gain, problem.time};
}

}  // namespace plumb
