// SPDX-License-Identifier: MIT
#include <plumb/ballistics/quadratic_drag_aim.h>

#include <cmath>
#include <optional>

#include <plumb/ballistics/detail/gravity_frame.h>
#include <plumb/ballistics/detail/input.h>
#include <plumb/ballistics/detail/quadratic_path.h>
#include <plumb/ballistics/fixed_speed.h>
#include <plumb/math/logarithm.h>
#include <plumb/math/trig.h>

namespace plumb {
namespace {

/// A launch, by how much its slope exceeds that of the line to the target.
struct Launched {
    double steeper = 0;
    double time = 0;        ///< to the target, in units of v / g
    bool straight = false;  ///< without effect of gravity: the other fields are not used
};

/// The problem in units of v^2 / g, with the target to the right and gravity down.
struct ScaledProblem {
    double across;    ///< x of the target, > 0
    double line;      ///< y / x of it
    double strength;  ///< 2 c v^2 / g
    double growth;    ///< by which factor a flat shot falls more on the way to the target than without drag

    struct Gap {
        double value;  ///< across / crossing - 1, positive when it falls short
        double slope;  ///< its derivative with respect to the slope of the launch
        double time;
    };
    std::optional<Gap> gapAt(double steeper) const {
        const std::optional<detail::Crossing> at = detail::crossingOf(line, steeper, strength);
        if (!at) return std::nullopt;
        const double ratio = across / at->across;
        return Gap{ratio - 1, -ratio * at->acrossSlope / at->across, at->time};
    }

    /// Without drag, and with this multiple of gravity: (b + S) / x, the excess slope of the high arc; NaN when no shot
    /// hits. That of the low arc is (1 + line^2) divided by it.
    double highArc(double gravities) const {
        const double x = gravities * across;
        const double b = 1 - x * line;
        const double limit = x * std::sqrt(1 + line * line);
        return (b + std::sqrt(b - limit) * std::sqrt(b + limit)) / x;
    }

    /// Newton's method, forward to the low arc or backward to the high one; outside is a start from which convergence
    /// is monotone.
    std::optional<Launched> zeroFrom(double start, double outside, bool forward) const {
        double steeper = start;
        for (int i = 0; i < 100; ++i) {
            const std::optional<Gap> gap = gapAt(steeper);
            if (!gap) return std::nullopt;
            const Launched here{steeper, gap->time};
            if (std::fabs(gap->value) <= 1e-13) return here;
            if (forward ? !(gap->slope < 0) : !(gap->slope > 0)) {
                if (gap->value > 0) return gap->value < 1e-11 ? std::optional(here) : std::nullopt;
                steeper = outside;  // the start was on the other arc's side
                continue;
            }
            const double step = -gap->value / gap->slope;
            if (std::fabs(step) <= 1e-14 * steeper) return here;
            steeper = steeper + step > 0 ? steeper + step : 0.5 * steeper;
        }
        return std::nullopt;
    }

    std::vector<Launched> launches() const {
        const double high = highArc(1);
        if (!std::isfinite(high)) return {};
        const double square = 1 + line * line;
        std::vector<Launched> found;
        if (across * growth * std::sqrt(square) < 1e-12) {
            found.push_back({.straight = true});  // gravity bends it by less than rounding
        } else {
            const double dragged = square / highArc(growth);
            const std::optional<Launched> first = zeroFrom(dragged > 0 ? dragged : square / high, square / high, true);
            if (!first) return {};
            found.push_back(*first);
        }
        // Its fourth power must be finite, and a longer flight is of no use.
        if (!(high < 1e60)) return found;
        const std::optional<Launched> last = zeroFrom(high, high, false);
        if (last && last->steeper > found[0].steeper) found.push_back(*last);
        return found;
    }
};

/// A shot straight up or down.
struct VerticalFlight {
    double speed, coefficient, gravity;
    double terminal = std::sqrt(gravity / coefficient);

    /// Times from the launch until a height is reached, going up and coming down.
    std::vector<double> timesUpTo(double height) const {
        const double start = speed / terminal;
        const double lost = (1 + start * start) * -exponentialMinus1(-2 * coefficient * height);
        const double square = start * start - lost;  // of the speed there over the terminal one
        if (square < 0) return {};
        const double end = std::sqrt(square);
        const double rise = arcTangent(lost / (start + end), 1 + start * end) * terminal / gravity;
        const double top = 0.5 * logarithm1Plus(square) / coefficient;
        return {rise, rise + arcTangent(end, 1) * terminal / gravity + timeToFall(top, 0)};
    }
    std::vector<double> timesDownTo(double depth) const {
        const double start = speed / terminal;
        const double top = 0.5 * logarithm1Plus(start * start) / coefficient;
        const double rise = arcTangent(start, 1) * terminal / gravity;
        return {timeToFall(depth, speed), rise + timeToFall(top + depth, 0)};
    }
    // e^(c s) = cosh z + q sinh z for z = g t / V: solved for e^z - 1.
    double timeToFall(double distance, double startSpeed) const {
        const double q = startSpeed / terminal;
        const double depth = coefficient * distance;
        if (depth > 300) return (depth + logarithm(2 / (1 + q))) * terminal / gravity;  // the rest is below e^-600
        const double grown = exponentialMinus1(2 * depth);
        const double first = exponentialMinus1(depth);
        const double root = grown > 0 ? grown / (std::sqrt(q * q + grown) + q) : 0;
        return logarithm1Plus((first + root) / (1 + q)) * terminal / gravity;
    }
};

void addFinite(std::vector<Shot>& shots, const Vec2& direction, double speed, double time) {
    if (std::isfinite(time) && std::isfinite(direction.x()) && std::isfinite(direction.y()))
        shots.push_back({detail::withLength(direction, speed), time});
}

void addStraight(std::vector<Shot>& shots, const QuadraticDragAim& problem, double distance) {
    const double z = problem.coefficient * distance;
    const double stretch = z > 0 ? exponentialMinus1(z) / z : 1;
    addFinite(shots, problem.target, problem.speed, stretch * (distance / problem.speed));
}

std::vector<Shot> verticalShots(const QuadraticDragAim& problem, const detail::GravityFrame& frame, double up) {
    const VerticalFlight flight{problem.speed, problem.coefficient, frame.gravity};
    const std::vector<double> times = up > 0 ? flight.timesUpTo(up) : flight.timesDownTo(-up);
    std::vector<Shot> shots;
    for (const double time : times) {
        if (!shots.empty() && !(time > shots.back().time)) continue;
        const bool firstDown = up < 0 && shots.empty();
        addFinite(shots, firstDown ? Vec2(-frame.up) : frame.up, problem.speed, time);
    }
    return shots;
}

}  // namespace

std::vector<Shot> aimThroughQuadraticDrag(const QuadraticDragAim& problem) {
    detail::requireSize(problem.target, "QuadraticDragAim", ".target");
    detail::requireAmount(problem.speed, "QuadraticDragAim", ".speed");
    detail::requireAmount(problem.coefficient, "QuadraticDragAim", ".coefficient");
    detail::requireSize(problem.gravity, "QuadraticDragAim", ".gravity");

    const double v = problem.speed;
    const double distance = detail::lengthOf(problem.target);
    detail::GravityFrame frame(problem.gravity);
    const double strength = 2 * problem.coefficient * v * (v / frame.gravity);
    const double z = 2 * problem.coefficient * distance;
    // Drag over weight, at the launch and for a fall over the whole distance: are both lost in rounding?
    if (distance <= detail::muzzle || problem.coefficient == 0 || (strength < 1e-17 && z < 1e-17))
        return aim({problem.target, v, problem.gravity});
    std::vector<Shot> shots;
    if (!(strength < 1e60)) {
        addStraight(shots, problem, distance);
        return shots;
    }

    const double up = problem.target.dot(frame.up);
    if (problem.target.dot(frame.right) < 0) frame.right = -frame.right;
    const double right = problem.target.dot(frame.right);
    // Off the vertical line by no more than rounding.
    if (!(right > 1e-15 * distance)) return verticalShots(problem, frame, up);

    if (strength == 0) return shots;  // too slow to leave that line
    const double growth = z < 1e-3 ? 1 + z / 3 : 2 * (exponentialMinus1(z) - z) / (z * z);
    const ScaledProblem scaled{right / v * (frame.gravity / v), up / right, strength, growth};
    for (const Launched& launch : scaled.launches())
        if (launch.straight)
            addStraight(shots, problem, distance);
        else
            addFinite(shots, frame.right + (scaled.line + launch.steeper) * frame.up, v,
                      launch.time * (v / frame.gravity));
    return shots;
}

}  // namespace plumb
