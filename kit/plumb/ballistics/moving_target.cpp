// SPDX-License-Identifier: MIT
#include <plumb/ballistics/moving_target.h>

#include <array>
#include <cmath>

#include <plumb/ballistics/detail/bracket.h>
#include <plumb/ballistics/detail/gravity_frame.h>
#include <plumb/ballistics/detail/input.h>
#include <plumb/ballistics/detail/straight_intercepts.h>

namespace plumb {
namespace {

using detail::ValueAndSlope;

/// A few numbers in increasing order.
struct Roots {
    std::array<double, 6> values{};
    std::size_t count = 0;
    void add(double root) { values[count++] = root; }  ///< must be larger than all others
    void insert(double root) {
        std::size_t at = count++;
        for (; at > 0 && values[at - 1] > root; --at) values[at] = values[at - 1];
        values[at] = root;
    }
};

struct Chase {
    Vec2 target, velocity;  ///< relative to the shooter
    Vec2 halfGravity;
    double speed;

    Vec2 positionAt(double t) const { return target + t * (velocity - t * halfGravity); }
    /// The distance of the target, minus the distance the shot can travel by then; gravity is applied to the target
    /// instead.
    ValueAndSlope gapAt(double t) const {
        const Vec2 position = positionAt(t);
        const double distance = detail::lengthOf(position);
        const Vec2 rate = velocity - 2 * t * halfGravity;
        return {distance - speed * t, (distance > 0 ? position.dot(rate) / distance : 0) - speed};
    }
    /// 0 where the gap is no more than rounding.
    int signAt(double t) const {
        const double gap = gapAt(t).value;
        const double parts = target.lpNorm<1>() + t * (velocity.lpNorm<1>() + t * halfGravity.lpNorm<1>() + speed);
        return std::fabs(gap) <= 2e-15 * parts ? 0 : gap > 0 ? 1 : -1;
    }
};

/// Coefficients of a polynomial of this degree, starting with the constant one.
template <std::size_t Degree>
using Polynomial = std::array<double, Degree + 1>;

template <std::size_t Degree>
ValueAndSlope valueAt(const Polynomial<Degree>& p, double t) {
    double value = p[Degree], slope = 0;
    for (std::size_t k = Degree; k-- > 0;) {
        slope = slope * t + value;
        value = value * t + p[k];
    }
    return {value, slope};
}

/// Roots between low and high, in order: one between each two neighbouring extrema with a change of sign.
template <std::size_t Degree>
Roots rootsOf(const Polynomial<Degree>& p, double low, double high);

template <std::size_t Degree>
Roots extremesOf(const Polynomial<Degree>& p, double low, double high) {
    Polynomial<Degree - 1> derivative{};
    for (std::size_t k = 0; k < Degree; ++k) derivative[k] = static_cast<double>(k + 1) * p[k + 1];
    return rootsOf<Degree - 1>(derivative, low, high);
}

template <std::size_t Degree>
Roots rootsOf(const Polynomial<Degree>& p, double low, double high) {
    Roots roots;
    if constexpr (Degree == 1) {
        const double root = -p[0] / p[1];
        if (root > low && root < high) roots.add(root);
    } else {
        Roots ends = extremesOf<Degree>(p, low, high);
        ends.add(high);
        double from = low;
        bool positive = valueAt<Degree>(p, low).value > 0;
        for (std::size_t i = 0; i < ends.count; ++i) {
            const bool next = valueAt<Degree>(p, ends.values[i]).value > 0;
            if (next != positive)
                roots.add(detail::rootBetween(from, ends.values[i], positive,
                                              [&](double t) { return valueAt<Degree>(p, t); }));
            from = ends.values[i];
            positive = next;
        }
    }
    return roots;
}

// Possible ends of brackets for the roots of the gap: between any two roots there is an extremum of its square. With
// almost no gravity the extrema are so far away that rounding hides the gap there; so the time at which a beam would
// hit the target, and twice that, are included.
Roots bracketEnds(const Chase& chase, const Polynomial<4>& squared, double low, double high) {
    Roots ends = extremesOf<4>(squared, low, high);
    const detail::Intercepts beam = detail::straightIntercepts(chase.target, chase.velocity, chase.speed);
    if (beam.count > 0)
        for (const double time : {beam.intercepts[0].time, 2 * beam.intercepts[0].time})
            if (time > low && time < high) ends.insert(time);
    ends.add(high);
    return ends;
}

Roots intercepts(const Chase& chase, double low, double high) {
    const Vec2 &d = chase.target, &w = chase.velocity, &h = chase.halfGravity;
    const Polynomial<4> squared = {d.squaredNorm(), 2 * d.dot(w),
                                   w.squaredNorm() - 2 * h.dot(d) - chase.speed * chase.speed, -2 * h.dot(w),
                                   h.squaredNorm()};
    const Roots ends = bracketEnds(chase, squared, low, high);
    Roots roots;
    double from = low;
    int sign = chase.signAt(low);
    for (std::size_t i = 0; i < ends.count; ++i) {
        const double end = ends.values[i];
        const int next = chase.signAt(end);
        if (next == 0 && sign != 0 && end < high) roots.add(end);
        if (next * sign < 0)
            roots.add(detail::rootBetween(from, end, sign > 0, [&](double t) { return chase.gapAt(t); }));
        from = end;
        sign = next;
    }
    return roots;
}

// Without gravity, shots and target move in straight lines in the shooter's frame.
Roots straightIntercepts(const Chase& chase, double longest) {
    const detail::Intercepts beam = detail::straightIntercepts(chase.target, chase.velocity, chase.speed);
    Roots roots;
    for (std::size_t i = 0; i < beam.count; ++i)
        if (beam.intercepts[i].time <= longest) roots.add(beam.intercepts[i].time);
    return roots;
}

void require(const MovingAim& problem) {
    detail::requireSize(problem.target, "MovingAim", ".target");
    detail::requireSize(problem.targetVelocity, "MovingAim", ".targetVelocity");
    detail::requireSize(problem.shooterVelocity, "MovingAim", ".shooterVelocity");
    detail::requireAmount(problem.speed, "MovingAim", ".speed");
    detail::requireSize(problem.gravity, "MovingAim", ".gravity");
}

}  // namespace

std::vector<Shot> aimAtMoving(const MovingAim& problem) {
    require(problem);
    const Chase chase{problem.target, problem.targetVelocity - problem.shooterVelocity, 0.5 * problem.gravity,
                      problem.speed};
    const double distance = detail::lengthOf(chase.target);
    const double gravity = detail::lengthOf(problem.gravity);
    if (distance <= detail::muzzle)
        return {{chase.speed * detail::GravityFrame(problem.gravity).up + problem.shooterVelocity, 0}};

    // Before low, the shot and the target together cannot have covered the distance, even straight at each other; after
    // high, gravity has taken the shot farther than both can compensate. Both limits are widened a little for rounding.
    const double closing = chase.speed + detail::lengthOf(chase.velocity);
    const double root = std::sqrt(closing * closing + 2 * gravity * distance);
    constexpr double longest = 1e70;
    const double low = 0.999 * 2 * distance / (closing + root);
    const double high = std::min(longest, 1.001 * (closing + root) / gravity);
    std::vector<Shot> shots;
    if (!(low < high)) return shots;
    const Roots roots = gravity > 0 ? intercepts(chase, low, high) : straightIntercepts(chase, longest);
    for (std::size_t i = 0; i < roots.count; ++i) {
        const double t = roots.values[i];
        const Vec2 velocity = chase.target / t + chase.velocity - t * chase.halfGravity;
        shots.push_back({detail::withLength(velocity, chase.speed) + problem.shooterVelocity, t});
    }
    return shots;
}

}  // namespace plumb
