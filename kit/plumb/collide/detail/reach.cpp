// SPDX-License-Identifier: MIT
#include <plumb/collide/detail/reach.h>

#include <plumb/shapes/aabb.h>

namespace plumb {

void requireReach(const Way& way, const std::string& name) {
    requireReach(way.start, name, ".start");
    requireReach(way.shift, name, ".shift");
    requireFinite(way.angle, name, ".angle");
    requireWithin(way.turn, -farthestReach, farthestReach, name, ".turn");
    requireReach(way.localCenter, name, ".localCenter");
}

void requireReach(const Shape& shape, const std::string& name) {
    validate(shape, name);
    const Aabb box = aabbOf(shape, {});
    requireReach(box.lower, name, ": box.lower");
    requireReach(box.upper, name, ": box.upper");
}

}  // namespace plumb
