// SPDX-License-Identifier: MIT
// Which periodic images does a box extend into, in a space that wraps around? A part of space.h, which includes it.
#pragma once
#include <algorithm>

#include <plumb/space/space.h>

namespace plumb {

namespace periodic {

/// More images than this along an axis are not visited, however large a box is [-].
inline constexpr double maxImages = 64;

/// The trees store a shifted box: it is enlarged by the rounding error of that shift.
inline Aabb padded(const Aabb& box) {
    return inflate(box, 0x1p-48 * box.lower.cwiseAbs().cwiseMax(box.upper.cwiseAbs()).maxCoeff());
}

/// The number of whole numbers from first to last; 0 if one is not finite.
inline int countFrom(double first, double last) {
    constexpr double most = 1 << 20;  // a longer ray is cut off
    const double count = last - first + 1;
    return count > 0 ? static_cast<int>(std::min(count, most)) : 0;
}

template <class Visit>
void forEachImage(const Vec2& first, const Vec2& last, Visit&& visit) {
    const int columns = countFrom(first.x(), last.x()), rows = countFrom(first.y(), last.y());
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) visit(Vec2(first.x() + i, first.y() + j));
}

}  // namespace periodic

/// The last image that a box extends into, but no more than maxImages from the first.
inline Vec2 Space::lastImage(const Aabb& box) const {
    const Vec2 most = wrap_.imageIndex(box.lower).array() + (periodic::maxImages - 1);
    return wrap_.imageIndex(box.upper).cwiseMin(most);
}

template <class Visitor>
void Space::forEachShift(const Aabb& still, const Aabb& box, Visitor&& visitor) const {
    // One more image at both ends, because the division is rounded.
    const Vec2 one(wrap_.width ? 1 : 0, wrap_.height ? 1 : 0);
    const Vec2 first = wrap_.imageIndex(still.lower - box.upper) - one;
    const Vec2 most = first.array() + (periodic::maxImages + 2);
    const Vec2 last = (wrap_.imageIndex(still.upper - box.lower) + one).cwiseMin(most);
    periodic::forEachImage(first, last, [&](const Vec2& image) {
        const Vec2 shift = wrap_.imageOffset(image);
        if (overlap(still, shifted(box, shift))) visitor(shift);
    });
}

}  // namespace plumb
