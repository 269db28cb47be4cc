// SPDX-License-Identifier: MIT
#include <plumb/collide/detail/sweep_limits.h>

#include <plumb/shapes/aabb.h>

namespace plumb {

void requireInRange(const Sweep& sweep, const std::string& name) {
    requireInRange(sweep.start, name, ".start");
    requireInRange(sweep.shift, name, ".shift");
    requireFinite(sweep.angle, name, ".angle");
    requireWithin(sweep.turn, -maxMagnitude, maxMagnitude, name, ".turn");
    requireInRange(sweep.localCenter, name, ".localCenter");
}

void requireInRange(const Shape& shape, const std::string& name) {
    validate(shape, name);
    const Aabb box = aabbOf(shape, {});
    requireInRange(box.lower, name, ": box.lower");
    requireInRange(box.upper, name, ": box.upper");
}

}  // namespace plumb
