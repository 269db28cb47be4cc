// SPDX-License-Identifier: MIT
// Which rounds does a box reach into, in a space that wraps around? A part of space.h, which includes it.
#pragma once
#include <algorithm>

#include <plumb/space/space.h>

namespace plumb {

namespace around {

/// More rounds than this along an axis are not looked at, of a box that reaches into so many [-].
inline constexpr double mostRounds = 64;

/// What stands in the hierarchies is counted from another round: its box is larger by some roundings.
inline Aabb spare(const Aabb& box) {
    return inflate(box, 0x1p-48 * box.lower.cwiseAbs().cwiseMax(box.upper.cwiseAbs()).maxCoeff());
}

/// How many whole numbers from one to another, none if one is not finite.
inline int countFrom(double first, double last) {
    constexpr double most = 1 << 20;  // a way that goes round more often is cut off
    const double count = last - first + 1;
    return count > 0 ? static_cast<int>(std::min(count, most)) : 0;
}

template <class Visit>
void forEachRound(const Vec2& first, const Vec2& last, Visit&& visit) {
    const int columns = countFrom(first.x(), last.x()), rows = countFrom(first.y(), last.y());
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) visit(Vec2(first.x() + i, first.y() + j));
}

}  // namespace around

/// The last round that a box reaches into, and no more than mostRounds from the first.
inline Vec2 Space::lastRound(const Aabb& box) const {
    const Vec2 most = wrap_.roundOf(box.lower).array() + (around::mostRounds - 1);
    return wrap_.roundOf(box.upper).cwiseMin(most);
}

template <class Look>
void Space::forEachShift(const Aabb& still, const Aabb& box, Look&& look) const {
    // A round more at both ends, for the roundings of the division.
    const Vec2 one(wrap_.width ? 1 : 0, wrap_.height ? 1 : 0);
    const Vec2 first = wrap_.roundOf(still.lower - box.upper) - one;
    const Vec2 most = first.array() + (around::mostRounds + 2);
    const Vec2 last = (wrap_.roundOf(still.upper - box.lower) + one).cwiseMin(most);
    around::forEachRound(first, last, [&](const Vec2& rounds) {
        const Vec2 shift = wrap_.lengthOf(rounds);
        if (overlap(still, shifted(box, shift))) look(shift);
    });
}

}  // namespace plumb
