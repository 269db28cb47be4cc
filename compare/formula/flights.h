// SPDX-License-Identifier: MIT
// In which flights does a ball move that is dropped on a floor?
#pragma once
#include <cmath>
#include <vector>

#include <plumb/math/vec2.h>

namespace plumb::compare {

/// Constant acceleration from start on: x = x0 + v0 s + a s^2 / 2 with s = t - start; the angle in the same way.
struct Flight {
    double start = 0;                ///< [s]
    Vec2 position{0, 0};             ///< at start, of the body's origin [m]
    Vec2 velocity{0, 0};             ///< [m/s]
    Vec2 acceleration{0, 0};         ///< [m/s^2]
    double angle = 0;                ///< [rad]
    double angularVelocity = 0;      ///< [rad/s]
    double angularAcceleration = 0;  ///< [rad/s^2]
};

struct DroppedBall {
    Vec2 rest{0, 0};            ///< the place of its centre when it touches the floor [m]
    double height = 5;          ///< the height above rest from which it is dropped [m]
    double restitution = 1;     ///< e, 0 to 1 [-]
    double gravity = 9.81;      ///< [m/s^2]
    double until = 10;          ///< flights that start later are left out [s]
    double shortestFlight = 0;  ///< the first flight shorter than this, and all after it, count as rest [s]
};

/// Fall t0 = sqrt(2 h / g); flight n = 1, 2, ... leaves the floor at e^n sqrt(2 g h) and lasts 2 t0 e^n.
/// h height [m], g gravity [m/s^2], e restitution [-]
/// Source: textbook; Newton's law of impact at each landing. Exact.
/// Tests: "a ball dropped from 1 m at e = 0.8 bounces for 4.0637127689 s",
///        "a ball dropped from 5 m at e = 1 returns to 5 m twenty times"
inline std::vector<Flight> bouncingFlights(const DroppedBall& ball) {
    const Vec2 down(0, -ball.gravity);
    const double fall = std::sqrt(2 * ball.height / ball.gravity);
    std::vector<Flight> flights{{.position = ball.rest + Vec2(0, ball.height), .acceleration = down}};
    double start = fall;
    double speed = ball.gravity * fall;
    while (start <= ball.until) {
        speed *= ball.restitution;
        const double lasts = 2 * speed / ball.gravity;
        if (lasts <= ball.shortestFlight) {
            flights.push_back({.start = start, .position = ball.rest});
            break;
        }
        flights.push_back({.start = start, .position = ball.rest, .velocity = {0, speed}, .acceleration = down});
        start += lasts;
    }
    return flights;
}

}  // namespace plumb::compare
