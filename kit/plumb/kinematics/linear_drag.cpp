// SPDX-License-Identifier: MIT
#include <plumb/kinematics/linear_drag.h>

#include <plumb/math/check.h>
#include <plumb/math/trig.h>

namespace plumb {

namespace {

// (x - 1 + e^-x) / x^2 by its series 1/2! - x/3! + x^2/4! ..., whose next term is below 1e-17 up to x = 2.
double reachFactor(double x) {
    double sum = 0;
    for (int n = 25; n >= 2; --n) sum = (1 - x * sum) / n;
    return sum;
}

}  // namespace

DragStep uncheckedDragStep(double rate, double time) {
    const double x = rate * time;
    if (x < 1e-17) return {1, time, 0.5 * time * time};
    const double gain = -exponentialMinus1(-x);
    if (x > 2) return {exponential(-x), gain / rate, (time - gain / rate) / rate};
    return {exponential(-x), gain / rate, reachFactor(x) * time * time};
}

DragStep dragStep(double rate, double time) {
    requireNotNegative(rate, "rate");
    requireNotNegative(time, "time");
    return uncheckedDragStep(rate, time);
}

PointMotion moveWithDrag(const PointMotion& from, const DragLaw& law, double time) {
    requireFinite(from.position, "PointMotion.position");
    requireFinite(from.velocity, "PointMotion.velocity");
    requireFinite(law.wind, "DragLaw.wind");
    requireFinite(law.acceleration, "DragLaw.acceleration");
    requireNotNegative(law.rate, "DragLaw.rate");
    const DragStep step = dragStep(law.rate, time);
    const Vec2 relative = from.velocity - law.wind;
    return {from.position + law.wind * time + relative * step.gain + law.acceleration * step.reach,
            law.wind + relative * step.keep + law.acceleration * step.gain};
}

}  // namespace plumb
