// SPDX-License-Identifier: MIT
#include <plumb/kinematics/detail/drag_step.h>

#include <plumb/math/trig.h>

namespace plumb::detail {
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

}  // namespace plumb::detail
