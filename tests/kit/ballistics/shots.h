// SPDX-License-Identifier: MIT
// Which random problems are aimed at, and how far from its target does a shot come, by a route that is not the
// solver's?
#pragma once
#include <algorithm>
#include <cmath>
#include <iostream>
#include <sstream>
#include <string>
#include <utility>

#include <plumb/ballistics/shot.h>
#include <plumb/math/check.h>
#include <plumb/math/random.h>
#include <plumb/math/rot.h>

#include "numbers.h"

namespace plumb::test {

using Real = long double;

/// The largest of many numbers, and the problem it was found at.
class Worst {
public:
    explicit Worst(std::string name) : name_(std::move(name)) {}
    /// where() says which problem it is, when that is asked.
    template <typename Where>
    void hold(double value, const Where& where) {
        ++count_;
        if (value <= value_) return;
        value_ = value;
        where_ = where();
    }
    double value() const { return value_; }
    void print() const {
        std::cout << name_ << ": at most " << value_ << " over " << count_ << "; at " << where_ << '\n';
    }

private:
    std::string name_, where_ = "none";
    double value_ = 0;
    int count_ = 0;
};

/// "target (1, 2) speed 3", of names and values by turns.
template <typename... Parts>
std::string describe(const Parts&... parts) {
    std::ostringstream out;
    out.precision(17);
    const auto add = [&](const auto& part) {
        if constexpr (std::is_convertible_v<decltype(part), Vec2> &&
                      !std::is_arithmetic_v<std::decay_t<decltype(part)>>)
            out << toText(part) << ' ';
        else
            out << part << ' ';
    };
    (add(parts), ...);
    return out.str();
}

/// From low to high, every order of magnitude as often.
inline double magnitude(Random& random, double low, double high) {
    return low * std::exp(random.uniform(0, std::log(high / low)));
}

inline Vec2 towards(double angle, double length) {
    return {length * std::cos(angle), length * std::sin(angle)};
}

/// Down, or one time in two in any direction; 0.01 to 100.
inline Vec2 randomGravity(Random& random) {
    const double size = magnitude(random, 0.01, 100);
    return random.integer(0, 1) == 0 ? Vec2(0, -size) : towards(random.uniform(-pi, pi), size);
}

struct Point {
    Real x, y;
};

inline Real length(const Point& p) {
    return std::sqrt(p.x * p.x + p.y * p.y);
}

/// x along the level to the right, y against gravity.
inline Point seenUpright(const Vec2& v, const Vec2& gravity) {
    const Real gx = gravity.x(), gy = gravity.y(), g = std::sqrt(gx * gx + gy * gy);
    const Real x = v.x(), y = v.y();
    return {(gx * y - gy * x) / g, -(gx * x + gy * y) / g};
}

/// Simpson's rule on the speed over 32 intervals: to a few parts in a thousand, which is all it is needed for.
inline double pathLength(const Shot& shot, const Vec2& gravity) {
    constexpr int intervals = 32;
    double sum = 0;
    for (int i = 0; i <= intervals; ++i) {
        const double speed = (shot.velocity + shot.time * i / intervals * gravity).norm();
        sum += speed * (i == 0 || i == intervals ? 1 : i % 2 ? 4 : 2);
    }
    return sum * shot.time / (3 * intervals);
}

/// Distance from the target at the shot's time, in long double.
inline double missAtTime(const Shot& shot, const Vec2& target, const Vec2& gravity) {
    const Real t = shot.time;
    const Point off{shot.velocity.x() * t + gravity.x() * t * t / 2 - target.x(),
                    shot.velocity.y() * t + gravity.y() * t * t / 2 - target.y()};
    return static_cast<double>(length(off));
}

/// Distance of the path from the target, by the lecture's other form, which knows angles and no time (slide 14):
///   y = x tan a - g x^2 / (2 v^2 cos^2 a)
/// its error of height times the cosine of the path there.
inline double missByAngle(const Shot& shot, const Vec2& target, const Vec2& gravity) {
    const Point u = seenUpright(shot.velocity, gravity), d = seenUpright(target, gravity);
    const Real g = length({gravity.x(), gravity.y()}), v = length(u);
    const Real angle = std::atan2(u.y, u.x), cosine = std::cos(angle);
    const Real slope = std::tan(angle) - g * d.x / (v * v * cosine * cosine);
    const Real height = d.x * std::tan(angle) - g * d.x * d.x / (2 * v * v * cosine * cosine);
    return static_cast<double>(std::fabs(height - d.y) / std::sqrt(1 + slope * slope));
}

/// How far out of reach of all shots of a speed a target is, over its distance: by the parabola of safety,
///   y = v^2 / (2 g) - g x^2 / (2 v^2)
/// (Torricelli, 1644). Negative within.
inline double beyondReach(double speed, const Vec2& target, const Vec2& gravity) {
    const Point d = seenUpright(target, gravity);
    const Real g = length({gravity.x(), gravity.y()}), v = speed;
    return static_cast<double>((d.y - (v * v / (2 * g) - g * d.x * d.x / (2 * v * v))) / length(d));
}

}  // namespace plumb::test
