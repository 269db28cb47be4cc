// SPDX-License-Identifier: MIT
// How does a shot fly through the air, by integration of its acceleration alone?
#pragma once
#include <array>
#include <cmath>
#include <optional>

#include <Eigen/Core>

#include "kit/ballistics/shots.h"

namespace plumb::test {

/// x, y, x', y'.
using FlightVector = Eigen::Vector4d;

struct LinearAir {
    double rate = 0;
    Vec2 wind{0, 0}, gravity{0, -9.81};
    Vec2 accelerationAt(const Vec2& velocity) const { return gravity - rate * (velocity - wind); }
};

struct QuadraticAir {
    double coefficient = 0;
    Vec2 gravity{0, -9.81};
    Vec2 accelerationAt(const Vec2& velocity) const { return gravity - coefficient * velocity.norm() * velocity; }
};

/// Steps of Dormand and Prince's method of order 5 with the error of its order 4 ("A family of embedded
/// Runge-Kutta formulae", 1980, table 2), each as long as a tolerance allows; calls arrive(state, time) after
/// each, and stops at the end, or when that says so.
template <typename Air, typename Arrive>
void fly(const Air& air, const Vec2& velocity, double end, double tolerance, const Arrive& arrive) {
    static constexpr double a[7][6] = {{},
                                       {1.0 / 5},
                                       {3.0 / 40, 9.0 / 40},
                                       {44.0 / 45, -56.0 / 15, 32.0 / 9},
                                       {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
                                       {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
                                       {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}};
    static constexpr double error[7] = {71.0 / 57600,      0,          -71.0 / 16695, 71.0 / 1920,
                                        -17253.0 / 339200, 22.0 / 525, -1.0 / 40};
    const auto rateOf = [&](const FlightVector& s) {
        const Vec2 acceleration = air.accelerationAt({s[2], s[3]});
        return FlightVector(s[2], s[3], acceleration.x(), acceleration.y());
    };
    FlightVector state(0, 0, velocity.x(), velocity.y());
    double time = 0, step = end / 100;
    while (time < end) {
        step = std::min(step, end - time);
        std::array<FlightVector, 7> k;
        FlightVector next = state, off = FlightVector::Zero();
        for (std::size_t i = 0; i < 7; ++i) {
            next = state;
            for (std::size_t j = 0; j < i; ++j) next += step * a[i][j] * k[j];
            k[i] = rateOf(next);
            off += step * error[i] * k[i];
        }
        // Places to a part of the way that a step at this speed is; speeds to a part of the speed.
        const double speed = std::max(state.tail<2>().norm(), next.tail<2>().norm());
        const double size = std::max(off.head<2>().norm() / (speed * step), off.tail<2>().norm() / speed) / tolerance;
        if (size <= 1) {
            time = step == end - time ? end : time + step;
            state = next;
            if (arrive(state, time)) return;
        }
        step *= size < 1e4 ? std::clamp(0.9 * std::pow(size + 1e-10, -0.2), 0.2, 5.0) : 0.1;  // or it is no number
    }
}

struct FlownShot {
    double miss = 0;  ///< distance from the target at the shot's time
    double path = 0;  ///< length
};

/// To a tolerance a step; without one, to 1e-9, and where that is not enough to tell a miss of 1e-9, to 1e-12.
template <typename Air>
FlownShot flyShot(const Air& air, const Shot& shot, const Vec2& target, double tolerance = 0) {
    FlownShot flown;
    Vec2 last(0, 0);
    fly(air, shot.velocity, shot.time, tolerance > 0 ? tolerance : 1e-9, [&](const FlightVector& s, double time) {
        const Vec2 place(s[0], s[1]);
        flown.path += (place - last).norm();
        last = place;
        if (time == shot.time) flown.miss = (place - target).norm();
        return false;
    });
    const bool unclear = tolerance == 0 && flown.miss > 1e-9 * flown.path;
    return unclear ? flyShot(air, shot, target, 1e-12) : flown;
}

struct Pass {
    double distance = INFINITY;  ///< of the target at the closest
    bool left = false;           ///< the target is to the left of the path there
};

/// Closest approach of a path to a target; each step's cubic (Hermite's) is looked at in eight chords.
template <typename Air>
Pass passBy(const Air& air, const Vec2& velocity, const Vec2& target, double end) {
    Pass pass;
    FlightVector from(0, 0, velocity.x(), velocity.y());
    double before = 0;
    fly(air, velocity, end, 1e-7, [&](const FlightVector& to, double time) {
        const double step = time - before;
        Vec2 last = from.head<2>();
        for (int k = 1; k <= 8; ++k) {
            const double p = k / 8.0, q = 1 - p;
            const Vec2 next = q * q * ((1 + 2 * p) * from.head<2>() + p * step * from.tail<2>()) +
                              p * p * ((1 + 2 * q) * to.head<2>() - q * step * to.tail<2>());
            const Vec2 chord = next - last, off = target - last;
            const double part = std::clamp(off.dot(chord) / chord.squaredNorm(), 0.0, 1.0);
            const double distance = (off - part * chord).norm();
            if (distance < pass.distance) pass = {distance, cross(chord, off) > 0};
            last = next;
        }
        from = to;
        before = time;
        return last.norm() > 20 * target.norm();
    });
    return pass;
}

/// Does any angle hit? Of 360, two neighbours that pass close by a target on different sides have one between them
/// that does; it is looked for by bisection. Two hits within one degree are not seen.
template <typename Air>
bool someAngleHits(const Air& air, double speed, const Vec2& target, double end) {
    const double near = 0.2 * target.norm();
    double low = 0;
    Pass lowPass = passBy(air, {speed, 0}, target, end);
    for (int k = 1; k <= 360; ++k) {
        const double high = k * pi / 180;
        const Pass highPass = passBy(air, towards(high, speed), target, end);
        if (lowPass.left != highPass.left && lowPass.distance < near && highPass.distance < near) {
            double a = low, b = high, closest = near;
            for (int i = 0; i < 40 && closest > 1e-6 * target.norm(); ++i) {
                const double middle = 0.5 * (a + b);
                const Pass pass = passBy(air, towards(middle, speed), target, end);
                closest = std::min(closest, pass.distance);
                (pass.left == lowPass.left ? a : b) = middle;
            }
            if (closest <= 1e-6 * target.norm()) return true;
        }
        low = high;
        lowPass = highPass;
    }
    return false;
}

}  // namespace plumb::test
