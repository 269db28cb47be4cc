// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joint_def.h>

#include <cmath>

#include <plumb/math/check.h>

namespace plumb {

Spring springOf(double frequency, double dampingRatio, double mass) {
    requireNotNegative(frequency, "springOf: frequency");
    requireNotNegative(dampingRatio, "springOf: dampingRatio");
    requireNotNegative(mass, "springOf: mass");
    const double omega = 2 * 3.14159265358979323846 * frequency;
    const Spring spring{mass * omega * omega, 2 * dampingRatio * mass * omega};
    if (!std::isfinite(spring.stiffness) || !std::isfinite(spring.damping))
        refuse("springOf: frequency", toText(frequency) + " makes stiffness and damping " +
                                          toText(Vec2(spring.stiffness, spring.damping)) + ", not finite");
    return spring;
}

}  // namespace plumb
