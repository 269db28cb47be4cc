// SPDX-License-Identifier: MIT
#include <plumb/shapes/shape.h>

#include <plumb/math/check.h>

namespace plumb {

Polygon boxPolygon(const Vec2& halfSize, const Vec2& center) {
    requirePositive(halfSize, "box.halfSize");
    requireFinite(center, "box.center");
    const double w = halfSize.x();
    const double h = halfSize.y();
    return {{center + Vec2(-w, -h), center + Vec2(w, -h), center + Vec2(w, h), center + Vec2(-w, h)}};
}

}  // namespace plumb
