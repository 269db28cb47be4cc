// SPDX-License-Identifier: MIT
#include <plumb/kinematics/constant_acceleration.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include <plumb/math/check.h>
#include <plumb/math/detail/exact.h>
#include <plumb/math/detail/sorting.h>

namespace plumb {
namespace {

// a b + c d within two units in its last place, its sign always correct.
// Source: Kahan's difference of products, with Dekker's product; Jeannerod, Louvet, Muller, Math. Comp. 82, 2013.
double sumOfProducts(double a, double b, double c, double d) {
    const Exact ab = exactProduct(a, b), cd = exactProduct(c, d);
    const Exact sum = exactSum(ab.value, cd.value);
    const double lost = sum.lost + (ab.lost + cd.lost);
    return std::isfinite(lost) ? sum.value + lost : sum.value;
}

MotionSolutions one(const SolvedMotion& motion) {
    return {{motion}, false};
}
// When an equation reduces to 0 x = rest.
MotionSolutions allOrNone(double rest) {
    return {{}, rest == 0};
}

// The seven combinations that include the start velocity, or neither velocity; the other three are these with time
// reversed.

MotionSolutions ofStartAccelerationTime(double u, double a, double t) {
    return one({t * sumOfProducts(u, 1, 0.5 * a, t), u, sumOfProducts(u, 1, a, t), a, t});
}

MotionSolutions ofVelocitiesTime(double u, double v, double t) {
    if (t == 0) return allOrNone(v - u);
    return one({0.5 * (u + v) * t, u, v, (v - u) / t, t});
}

MotionSolutions ofDistanceStartTime(double d, double u, double t) {
    if (t == 0) return allOrNone(d);
    return one({d, u, sumOfProducts(2, d, -u, t) / t, 2 * (sumOfProducts(1, d, -u, t) / t / t), t});
}

MotionSolutions ofDistanceAccelerationTime(double d, double a, double t) {
    if (t == 0) return allOrNone(d);
    // u = d / t - a t / 2 and v = d / t + a t / 2, with the rounding error of the quotient added back
    const double mean = d / t;
    const Exact back = exactProduct(mean, t);
    const double lost = ((d - back.value) - back.lost) / t;
    const Exact half = exactProduct(0.5 * a, t);
    const Exact start = exactSum(mean, -half.value), end = exactSum(mean, half.value);
    return one({d, start.value + (start.lost + (lost - half.lost)), end.value + (end.lost + (lost + half.lost)), a, t});
}

MotionSolutions ofVelocitiesAcceleration(double u, double v, double a) {
    if (a == 0) return allOrNone(v - u);
    return one({0.5 * (u + v) * ((v - u) / a), u, v, a, (v - u) / a});
}

MotionSolutions ofDistanceVelocities(double d, double u, double v) {
    if (u + v == 0) return allOrNone(d);
    if (d == 0) return allOrNone(v - u);  // no time passes, so any acceleration is a solution
    const double t = 2 * (d / (u + v));
    return one({d, u, v, (v - u) / t, t});
}

// a t^2 / 2 + u t - d = 0, by v^2 = u^2 + 2 a d: t = (v - u) / a = 2 d / (u + v).
MotionSolutions ofDistanceStartAcceleration(double d, double u, double a) {
    if (a == 0) {
        if (u == 0) return allOrNone(d);
        return one({d, u, u, a, d / u});
    }
    const double square = sumOfProducts(u, u, 2 * a, d);
    if (square < 0) return {};
    if (square == 0) return one({d, u, 0, a, -u / a});
    const double v = std::copysign(std::sqrt(square), u);  // with the sign of u, so that u + v does not cancel
    return {{{d, u, v, a, 2 * (d / (u + v))}, {d, u, -v, a, -(u + v) / a}}, false};
}

MotionSolutions solveForwards(const KnownMotion& k) {
    const std::optional<double>&d = k.displacement, &u = k.startVelocity, &v = k.endVelocity, &a = k.acceleration,
          &t = k.time;
    if (t && a) return u ? ofStartAccelerationTime(*u, *a, *t) : ofDistanceAccelerationTime(*d, *a, *t);
    if (t) return v ? ofVelocitiesTime(*u, *v, *t) : ofDistanceStartTime(*d, *u, *t);
    if (!d) return ofVelocitiesAcceleration(*u, *v, *a);
    return v ? ofDistanceVelocities(*d, *u, *v) : ofDistanceStartAcceleration(*d, *u, *a);
}

std::optional<double> negated(const std::optional<double>& number) {
    return number ? std::optional(-*number) : std::nullopt;
}

MotionSolutions solve(const KnownMotion& k) {
    if (k.startVelocity || !k.endVelocity) return solveForwards(k);
    // The same motion with time reversed: start and end velocity are exchanged, displacement and time are negated.
    MotionSolutions solutions =
        solveForwards({negated(k.displacement), k.endVelocity, k.startVelocity, k.acceleration, negated(k.time)});
    for (SolvedMotion& motion : solutions.motions)
        motion = {-motion.displacement, motion.endVelocity, motion.startVelocity, motion.acceleration, -motion.time};
    return solutions;
}

/// Lists the names of the given quantities: "displacement, time".
struct Given {
    std::string_view whole;  ///< "KnownMotion"
    int count = 0;
    std::string names = {};

    template <typename Number>
    void add(const std::optional<Number>& number, const char* name) {
        if (!number) return;
        requireFinite(*number, std::string(whole) + ".", name);
        names += (count++ ? ", " : "") + std::string(name);
    }
    void requireCount(int wanted, const char* wish) const {
        if (count != wanted) refuse(whole, (count ? names : "nothing") + " is given; " + wish + " wanted");
    }
};

template <typename Known>
Given givenOf(const Known& known, std::string_view whole) {
    Given given{whole};
    given.add(known.displacement, "displacement");
    given.add(known.startVelocity, "startVelocity");
    given.add(known.endVelocity, "endVelocity");
    given.add(known.acceleration, "acceleration");
    return given;
}

bool isFinite(const SolvedMotion& m) {
    return std::isfinite(m.displacement) && std::isfinite(m.startVelocity) && std::isfinite(m.endVelocity) &&
           std::isfinite(m.acceleration) && std::isfinite(m.time);
}

// Removes the sign of zeros.
SolvedMotion tidy(const SolvedMotion& m) {
    return {m.displacement + 0.0, m.startVelocity + 0.0, m.endVelocity + 0.0, m.acceleration + 0.0, m.time + 0.0};
}

}  // namespace

MotionSolutions solveMotion(const KnownMotion& known, MotionTimes times) {
    Given given = givenOf(known, "KnownMotion");
    given.add(known.time, "time");
    given.requireCount(3, "three of the five are");
    const MotionSolutions all = solve(known);
    MotionSolutions solutions{{}, all.infinitelyMany};
    for (const SolvedMotion& motion : all.motions)
        if (isFinite(motion) && (times == MotionTimes::AnyReal || motion.time >= 0))
            solutions.motions.push_back(tidy(motion));
    sortBy(solutions.motions, [](const SolvedMotion& motion) { return motion.time; });
    return solutions;
}

PlaneMotionSolution solveMotion(const KnownPlaneMotion& known) {
    requireFinite(known.time, "KnownPlaneMotion.time");
    givenOf(known, "KnownPlaneMotion").requireCount(2, "two of the four vectors are");
    const auto along = [&](int axis) {
        const auto part = [&](const std::optional<Vec2>& vector) {
            return vector ? std::optional((*vector)[axis]) : std::nullopt;
        };
        return solveMotion({part(known.displacement), part(known.startVelocity), part(known.endVelocity),
                            part(known.acceleration), known.time},
                           MotionTimes::AnyReal);
    };
    const MotionSolutions x = along(0), y = along(1);
    if (!x.motions.empty() && !y.motions.empty()) {
        const SolvedMotion &a = x.motions[0], &b = y.motions[0];
        return {SolvedPlaneMotion{{a.displacement, b.displacement},
                                  {a.startVelocity, b.startVelocity},
                                  {a.endVelocity, b.endVelocity},
                                  {a.acceleration, b.acceleration},
                                  known.time},
                false};
    }
    return {std::nullopt, x.infinitelyMany && y.infinitelyMany};
}

PointMotion moveAccelerated(const PointMotion& from, const Vec2& acceleration, double time) {
    requireFinite(from.position, "PointMotion.position");
    requireFinite(from.velocity, "PointMotion.velocity");
    requireFinite(acceleration, "acceleration");
    requireFinite(time, "time");
    return {from.position + time * (from.velocity + 0.5 * time * acceleration), from.velocity + time * acceleration};
}

}  // namespace plumb
