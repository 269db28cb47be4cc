// SPDX-License-Identifier: MIT
#include <plumb/forces/drag.h>

#include <cmath>

#include <plumb/forces/detail/require_numbers.h>
#include <plumb/math/check.h>
#include <plumb/math/trig.h>

namespace plumb {
double quadraticDrag(double density, double dragCoefficient, double area) {
    requireNotNegative(density, "quadraticDrag: density");
    requireNotNegative(dragCoefficient, "quadraticDrag: dragCoefficient");
    requireNotNegative(area, "quadraticDrag: area");
    return 0.5 * density * dragCoefficient * area;
}

Vec2 dragForce(const Drag& drag, const Vec2& velocity) {
    requireNumbers(drag);
    const Vec2 u = velocity - drag.wind;
    return -(drag.linear + drag.quadratic * u.norm()) * u;
}

double terminalSpeed(const Drag& drag, double force) {
    requireNumbers(drag);
    requireNotNegative(force, "terminalSpeed: force");
    if (force == 0) return 0;
    return 2 * force / (drag.linear + std::sqrt(drag.linear * drag.linear + 4 * drag.quadratic * force));
}

Vec2 velocityAfterDrag(const Drag& drag, double mass, const Vec2& velocity, double time) {
    requireNumbers(drag);
    requirePositive(mass, "velocityAfterDrag: mass");
    requireNotNegative(time, "velocityAfterDrag: time");
    const double a = drag.linear / mass, b = drag.quadratic / mass;
    const double fade = exponentialMinus1(-a * time);
    const double reach = a > 0 ? -fade / a : time;
    const Vec2 u = velocity - drag.wind;
    return drag.wind + ((1 + fade) / (1 + b * u.norm() * reach)) * u;
}

}  // namespace plumb
