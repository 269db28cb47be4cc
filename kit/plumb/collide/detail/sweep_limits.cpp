// SPDX-License-Identifier: MIT
#include <plumb/collide/detail/sweep_limits.h>

#include <plumb/shapes/aabb.h>

namespace plumb {

void requireInRange(const Shape& shape, const std::string& name) {
    validate(shape, name);
    const Aabb box = aabbOf(shape, {});
    requireInRange(box.lower, name, ": box.lower");
    requireInRange(box.upper, name, ": box.upper");
}

}  // namespace plumb
