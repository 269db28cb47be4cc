// SPDX-License-Identifier: MIT
#include <compare/closed_form/disc_landing.h>

#include <algorithm>
#include <cmath>

namespace plumb::compare {
namespace {

/// The flight after a landing at the speed it comes down with.
Flight leave(const DroppedDisc& disc, const Flight& before, double time, double down) {
    const double s = time - before.start;
    const double slip = before.velocity.x() + before.angularVelocity * disc.radius;
    const double most = disc.friction * (1 + disc.restitution) * down;
    const double push = std::clamp(-slip * disc.inertiaRatio / (1 + disc.inertiaRatio), -most, most);
    return {.start = time,
            .position = {before.position.x() + before.velocity.x() * s, disc.rest.y()},
            .velocity = {before.velocity.x() + push, disc.restitution * down},
            .acceleration = before.acceleration,
            .angle = before.angle + before.angularVelocity * s,
            .angularVelocity = before.angularVelocity + push / (disc.inertiaRatio * disc.radius)};
}

}  // namespace

std::vector<Flight> landingFlights(const DroppedDisc& disc) {
    std::vector<Flight> flights{{.position = disc.rest + Vec2(0, disc.height),
                                 .velocity = {disc.speed, 0},
                                 .acceleration = {0, -disc.gravity},
                                 .angularVelocity = disc.angularVelocity}};
    double down = std::sqrt(2 * disc.gravity * disc.height);
    double time = down / disc.gravity;
    for (int i = 0; i < disc.landings; ++i) {
        flights.push_back(leave(disc, flights.back(), time, down));
        down *= disc.restitution;
        time += 2 * down / disc.gravity;
    }
    return flights;
}

}  // namespace plumb::compare
