// SPDX-License-Identifier: MIT
#include <compare/closed_form/disc_impact.h>

#include <cmath>

namespace plumb::compare {

std::optional<double> meetingTime(const FlyingDisc& a, const FlyingDisc& b) {
    const Vec2 d = b.position - a.position;
    const Vec2 w = b.velocity - a.velocity;
    const double reach = a.radius + b.radius;
    const double approach = -d.dot(w);
    const double discriminant = approach * approach - w.squaredNorm() * (d.squaredNorm() - reach * reach);
    if (approach <= 0 || discriminant < 0) return std::nullopt;
    // The product of the roots over the larger one: nothing cancels.
    return (d.squaredNorm() - reach * reach) / (approach + std::sqrt(discriminant));
}

DiscFlights collide(const FlyingDisc& a, const FlyingDisc& b, double restitution) {
    DiscFlights flights{{{.position = a.position, .velocity = a.velocity}},
                        {{.position = b.position, .velocity = b.velocity}}};
    const std::optional<double> time = meetingTime(a, b);
    if (!time) return flights;
    const Vec2 meetA = a.position + a.velocity * *time;
    const Vec2 meetB = b.position + b.velocity * *time;
    const Vec2 normal = (meetB - meetA).normalized();
    const double approach = (a.velocity - b.velocity).dot(normal);
    const double impulse = (1 + restitution) * approach / (1 / a.mass + 1 / b.mass);
    flights.a.push_back({.start = *time, .position = meetA, .velocity = a.velocity - normal * (impulse / a.mass)});
    flights.b.push_back({.start = *time, .position = meetB, .velocity = b.velocity + normal * (impulse / b.mass)});
    return flights;
}

}  // namespace plumb::compare
