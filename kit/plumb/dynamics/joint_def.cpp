// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joint_def.h>

#include <plumb/math/check.h>

namespace plumb {

Spring springOf(double frequency, double dampingRatio, double mass) {
    requireNotNegative(frequency, "springOf: frequency");
    requireNotNegative(dampingRatio, "springOf: dampingRatio");
    requireNotNegative(mass, "springOf: mass");
    const double omega = 2 * 3.14159265358979323846 * frequency;
    return {mass * omega * omega, 2 * dampingRatio * mass * omega};
}

}  // namespace plumb
