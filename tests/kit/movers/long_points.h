// SPDX-License-Identifier: MIT
// In which numbers are paths checked?
#pragma once
#include <array>
#include <cmath>

#include <plumb/math/vec2.h>

namespace plumb::test {

using Real = long double;

struct LongPoint {
    Real x = 0, y = 0;
    friend LongPoint operator+(LongPoint a, LongPoint b) { return {a.x + b.x, a.y + b.y}; }
    friend LongPoint operator-(LongPoint a, LongPoint b) { return {a.x - b.x, a.y - b.y}; }
    friend LongPoint operator*(Real s, LongPoint a) { return {s * a.x, s * a.y}; }
};
inline Real distance(LongPoint a, LongPoint b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}
inline LongPoint real(const Vec2& v) {
    return {v.x(), v.y()};
}

using Curve = std::array<Vec2, 4>;

}  // namespace plumb::test
