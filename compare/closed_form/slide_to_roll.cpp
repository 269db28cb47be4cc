// SPDX-License-Identifier: MIT
#include <compare/closed_form/slide_to_roll.h>

namespace plumb::compare {

std::vector<Flight> slideToRollFlights(const ThrownDisc& disc) {
    const double k = disc.inertiaRatio;
    const double braking = disc.friction * disc.gravity;
    const double spinUp = -braking / (k * disc.radius);
    const double time = disc.speed * k / ((1 + k) * braking);
    const Flight slide{.position = disc.position,
                       .velocity = {disc.speed, 0},
                       .acceleration = {-braking, 0},
                       .angularAcceleration = spinUp};
    const double rolling = disc.speed / (1 + k);
    const double way = (disc.speed + rolling) / 2 * time;
    const Flight roll{.start = time,
                      .position = disc.position + Vec2(way, 0),
                      .velocity = {rolling, 0},
                      .angle = spinUp * time * time / 2,
                      .angularVelocity = -rolling / disc.radius};
    return {slide, roll};
}

}  // namespace plumb::compare
