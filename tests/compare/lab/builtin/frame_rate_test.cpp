// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <string>

#include <compare/lab/builtin/labs.h>

#include "catch.h"

namespace plumb::compare {
namespace {

constexpr double gravity = 9.81, restitution = 0.9, radius = 0.25;

/// Above the floor after so many steps of v += a h; x += v h from x with v:
///   x_n = x + n v h - g h^2 n (n + 1) / 2
struct Flight {
    double x, v, h;
    double height(double n) const { return x + n * v * h - gravity * h * h * n * (n + 1) / 2; }
    double speed(double n) const { return v - gravity * h * n; }
    /// The first step after which it is below the floor: that after the larger root.
    double landing() const {
        const double a = gravity * h * h / 2, b = v * h - a;
        return std::floor((b + std::sqrt(b * b + 4 * a * x)) / (2 * a)) + 1;
    }
};

/// Dropped from 2 m, and mirrored by the floor at each landing.
double endAt(int rate) {
    Flight flight{2, 0, 1.0 / rate};
    double left = 3.0 * rate;
    for (double n = flight.landing(); n <= left; n = flight.landing()) {
        left -= n;
        flight = {-flight.height(n), -restitution * flight.speed(n), flight.h};
    }
    return radius + flight.height(left);
}

}  // namespace

TEST_CASE("the textbook's ball ends at 0.5355 m at 20 frames a second and at 1.1551 m at 24, from landing to landing",
          "[compare][lab]") {
    CHECK(std::fabs(endAt(20) - 0.5355) < 0.00005);
    CHECK(std::fabs(endAt(24) - 1.1551) < 0.00005);
    const LabRun run = frameRate().run({});
    const auto isTextbook = [](const Curve& curve) { return curve.name.starts_with("textbook"); };
    const std::vector<Curve>& curves = run.graphs.back().curves;
    const auto textbook = std::ranges::find_if(curves, isTextbook);
    REQUIRE(textbook != curves.end());
    CHECK(textbook->points.size() == 16);
    for (const Point& point : textbook->points) {
        CAPTURE(point.x);
        // 720 steps at most round a speed of up to 8 m/s by 4.4e-16, which counts for 3 s: 1e-12 m. Places and
        // landings add as much each.
        CHECK(std::fabs(point.y - endAt(static_cast<int>(point.x))) < 3e-12);
    }
}

}  // namespace plumb::compare
