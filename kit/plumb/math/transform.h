// SPDX-License-Identifier: MIT
// How are points transformed from a body's frame to the world?
#pragma once
#include <plumb/math/rot.h>

namespace plumb {

/// A rotation followed by a translation: local to world.
struct Transform {
    Vec2 position{0, 0};  ///< [m]
    Rot rotation;

    Transform inverse() const { return {rotation.inverse() * Vec2(-position.x(), -position.y()), rotation.inverse()}; }
};

inline Vec2 operator*(const Transform& t, const Vec2& local) {
    const Vec2 turned = t.rotation * local;
    return {turned.x() + t.position.x(), turned.y() + t.position.y()};
}
inline Transform operator*(const Transform& a, const Transform& b) {
    return {a * b.position, a.rotation * b.rotation};
}

}  // namespace plumb
