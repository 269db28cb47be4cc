// SPDX-License-Identifier: MIT
// What is the axis-aligned bounding box of a shape?
#pragma once
#include <plumb/math/transform.h>
#include <plumb/shapes/shape.h>

namespace plumb {

/// An axis-aligned bounding box [m].
struct Aabb {
    Vec2 lower{0, 0};
    Vec2 upper{0, 0};
};

inline bool overlap(const Aabb& a, const Aabb& b) {
    return a.lower.x() <= b.upper.x() && b.lower.x() <= a.upper.x() &&  //
           a.lower.y() <= b.upper.y() && b.lower.y() <= a.upper.y();
}
inline bool contains(const Aabb& outer, const Aabb& inner) {
    return outer.lower.x() <= inner.lower.x() && inner.upper.x() <= outer.upper.x() &&
           outer.lower.y() <= inner.lower.y() && inner.upper.y() <= outer.upper.y();
}
inline Aabb merge(const Aabb& a, const Aabb& b) {
    return {a.lower.cwiseMin(b.lower), a.upper.cwiseMax(b.upper)};
}
inline Aabb inflate(const Aabb& a, double margin) {
    return {{a.lower.x() - margin, a.lower.y() - margin}, {a.upper.x() + margin, a.upper.y() + margin}};
}

/// The smallest axis-aligned box of a placed shape. Throws std::invalid_argument on a polygon or chain with too few or
/// too many corners.
Aabb aabbOf(const Shape& shape, const Transform& pose);

}  // namespace plumb
