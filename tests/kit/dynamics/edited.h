// SPDX-License-Identifier: MIT
// What is edited, and what is looked at after it?
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include <plumb/plumb.h>

#include "kit/dynamics/worlds.h"

namespace plumb::test {

/// A box of ten by one under a box of one by one that sleeps on it.
struct Rest {
    World world;
    BodyId plank, box;
    explicit Rest(BodyType type = BodyType::Static, double tilt = 0) {
        const Rot turn = Rot::fromAngle(tilt);
        plank = world.add({.type = type, .angle = tilt, .shapes = {plumb::box({5, 0.5})}});
        box = world.add({.position = turn * Vec2(0, 1), .angle = tilt, .shapes = {plumb::box({0.5, 0.5})}});
        steps(world, 120);
    }
};

inline ShapeDef shapeAt(const Vec2& at) {
    return {.shape = boxPolygon({0.5, 0.25}, at)};
}

/// A body that flies and spins.
inline BodyDef spinning(std::vector<ShapeDef> shapes) {
    return {.position = {3, 4}, .angle = 0.7, .velocity = {2, -1}, .angularVelocity = 3, .shapes = std::move(shapes)};
}

/// Where its origin is, how it is turned, and how two of its points move.
inline std::vector<double> motionOf(const BodyView& body) {
    const Vec2 p = body.position(), v = body.velocityAt({0, 0}), w = body.velocityAt({10, 5});
    return {p.x(), p.y(), body.angle(), v.x(), v.y(), w.x(), w.y(), body.angularVelocity()};
}

inline double differenceOf(const std::vector<double>& a, const std::vector<double>& b) {
    double worst = 0;
    for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, std::fabs(a[i] - b[i]));
    return worst;
}

inline std::vector<BodyId> stackOf(World& world, int count) {
    world.add({.type = BodyType::Static, .shapes = {segment({-10, 0}, {10, 0})}});
    std::vector<BodyId> boxes;
    for (int i = 0; i < count; ++i) boxes.push_back(world.add({.position = {0, 0.5 + i}, .shapes = {box({0.5, 0.5})}}));
    return boxes;
}

}  // namespace plumb::test
