// SPDX-License-Identifier: MIT
#include <compare/formula/flights.h>

#include <cmath>

namespace plumb::compare {

std::vector<Flight> bouncingFlights(const DroppedBall& ball) {
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
