// SPDX-License-Identifier: MIT
// How is a rotation represented?
#pragma once
#include <plumb/math/trig.h>
#include <plumb/math/vec2.h>

namespace plumb {

/// A rotation, stored as the cosine and sine of its angle [-].
struct Rot {
    double cos = 1;
    double sin = 0;

    static Rot fromAngle(double angle) {
        const SinCos sc = sinCos(angle);
        return {sc.cos, sc.sin};
    }
    double angle() const { return arcTangent(sin, cos); }  ///< in (-pi, pi] [rad]
    Rot inverse() const { return {cos, -sin}; }
};

inline Vec2 operator*(const Rot& r, const Vec2& v) {
    return {r.cos * v.x() - r.sin * v.y(), r.sin * v.x() + r.cos * v.y()};
}
inline Rot operator*(const Rot& a, const Rot& b) {
    return {a.cos * b.cos - a.sin * b.sin, a.sin * b.cos + a.cos * b.sin};
}

}  // namespace plumb
