// SPDX-License-Identifier: MIT
#include <plumb/ballistics/quadratic_drag.h>

#include <cmath>

#include <plumb/ballistics/detail/input.h>
#include <plumb/math/logarithm.h>
#include <plumb/math/trig.h>

namespace plumb {
namespace {

void require(const QuadraticDrag& drag) {
    if (drag.coefficient != 0) detail::requirePositiveAmount(drag.coefficient, "QuadraticDrag", ".coefficient");
    detail::requirePositiveAmount(drag.gravity, "QuadraticDrag", ".gravity");
}

}  // namespace

double terminalSpeed(const QuadraticDrag& drag) {
    require(drag);
    return std::sqrt(drag.gravity / drag.coefficient);
}

VerticalShot shootUp(double speed, const QuadraticDrag& drag) {
    const double terminal = terminalSpeed(drag);
    detail::requireAmount(speed, "shootUp: ", "speed");
    if (drag.coefficient == 0) {
        const double rise = speed / drag.gravity;
        return {.riseTime = rise, .height = 0.5 * speed * rise, .fallTime = rise, .returnSpeed = speed};
    }
    const double ratio = speed / terminal;
    const double both = std::sqrt(1 + ratio * ratio);
    const double unit = terminal / drag.gravity;
    return {.riseTime = unit * arcTangent(ratio, 1),
            .height = 0.5 * unit * terminal * logarithm1Plus(ratio * ratio),
            // artanh(sin a) = arsinh(tan a), which loses no digits where sin a is close to 1
            .fallTime = unit * logarithm1Plus(ratio + ratio * ratio / (1 + both)),
            .returnSpeed = speed / both};
}

Fall fallFor(double time, const QuadraticDrag& drag) {
    const double terminal = terminalSpeed(drag);
    detail::requireAmount(time, "fallFor: ", "time");
    if (drag.coefficient == 0) return {.distance = 0.5 * drag.gravity * time * time, .speed = drag.gravity * time};
    const double z = drag.gravity * time / terminal;
    const double lost = -exponentialMinus1(-2 * z);
    // ln cosh z = z + ln(1 - lost / 2), and for a small z ln(1 + (e^z - 1)^2 / (2 e^z)).
    const double grown = exponentialMinus1(z < 1 ? z : 0);
    const double cosh = z < 1 ? logarithm1Plus(0.5 * grown * grown / (1 + grown)) : z + logarithm1Plus(-0.5 * lost);
    return {.distance = terminal * terminal / drag.gravity * cosh, .speed = terminal * lost / (2 - lost)};
}

}  // namespace plumb
