// SPDX-License-Identifier: MIT
#include <plumb/ballistics/detail/linear_drag_terms.h>

#include <array>

#include <plumb/math/trig.h>

namespace plumb::detail {
namespace {

// 1 / 2! - z / 3! + z^2 / 4! - ... = (z - 1 + e^-z) / z^2; the next term is below 1e-18 at z = 1/2.
double secondRest(double z) {
    constexpr std::array<double, 14> factorials = {
        2, 6, 24, 120, 720, 5040, 40320, 362880, 3628800, 39916800, 479001600, 6227020800, 87178291200, 1307674368000};
    double sum = 0;
    for (std::size_t k = factorials.size(); k-- > 0;) sum = 1 / factorials[k] - z * sum;
    return sum;
}

}  // namespace

LinearDragTerms linearDragTerms(double rate, double time) {
    const double z = rate * time;
    if (z < 0.5) {
        const double second = secondRest(z);
        const double first = 1 - z * second;
        return {1 - z * first, time * first, time * time * second};
    }
    const double lost = -exponentialMinus1(-z);
    const double reach = lost / rate;
    return {exponential(-z), reach, (time - reach) / rate};
}

}  // namespace plumb::detail
