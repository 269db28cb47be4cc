// SPDX-License-Identifier: MIT
#include <plumb/kinematics/linear_drag.h>

#include <plumb/kinematics/detail/drag_step.h>
#include <plumb/math/check.h>

namespace plumb {
DragStep dragStep(double rate, double time) {
    requireNotNegative(rate, "rate");
    requireNotNegative(time, "time");
    return detail::uncheckedDragStep(rate, time);
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
