// SPDX-License-Identifier: MIT
#include <plumb/kinematics/circular.h>

#include <plumb/math/check.h>
#include <plumb/math/trig.h>

namespace plumb {

CircularPoint circularAt(const CircularMotion& motion, double time) {
    requireFinite(motion.center, "CircularMotion.center");
    requireNotNegative(motion.radius, "CircularMotion.radius");
    requireFinite(motion.startAngle, "CircularMotion.startAngle");
    requireFinite(motion.angularVelocity, "CircularMotion.angularVelocity");
    requireFinite(time, "time");
    const double w = motion.angularVelocity;
    requireFinite(w * time, "CircularMotion.angularVelocity * time");
    requireFinite(motion.startAngle + w * time, "CircularMotion.startAngle + angularVelocity * time");
    requireFinite(w * (w * motion.radius), "CircularMotion.angularVelocity^2 * radius");
    const SinCos angle = sinCos(motion.startAngle + w * time);
    const Vec2 arm(motion.radius * angle.cos, motion.radius * angle.sin);
    return {motion.center + arm, w * perp(arm), -w * (w * arm)};
}

}  // namespace plumb
