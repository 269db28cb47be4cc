// SPDX-License-Identifier: MIT
// How do manifolds that are computed side by side compare with those that are computed one by one?
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include <plumb/collide/lanes/pair_lanes.h>
#include <plumb/collide/manifold.h>
#include <plumb/dynamics/bodies/body_store.h>

#include "catch.h"

namespace plumb::test {

template <class Pairs>
void addBody(Pairs& pairs, const Vec2& center, double angle) {
    BodyMotion motion;
    motion.center = center;
    motion.angle = angle;
    motion.rotation = Rot::fromAngle(angle);
    pairs.motion.push_back(motion);
    pairs.place.push_back(placeOf(motion, 1));
}

inline float nearestOf(const Manifold& m) {
    return m.count > 1 ? std::min(m.points[0].separation, m.points[1].separation) : m.points[0].separation;
}

inline Manifold manifoldIn(const FreshLanes& fresh, std::size_t lane) {
    Manifold m;
    m.normal = {fresh.normalX[lane], fresh.normalY[lane]};
    m.count = fresh.count[lane];
    for (std::size_t p = 0; p < 2; ++p)
        m.points[p] = {{fresh.points[p].x[lane], fresh.points[p].y[lane]},
                       fresh.points[p].separation[lane],
                       static_cast<std::uint16_t>(fresh.points[p].feature[lane])};
    return m;
}

/// Positions and separations; the order of the points is each one's own.
inline bool samePoints(const Manifold& a, const Manifold& b, float tolerance) {
    const auto same = [&](std::size_t p, std::size_t q) {
        const Vec2f moved = a.points[p].position - b.points[q].position;
        return moved.norm() < tolerance && std::fabs(a.points[p].separation - b.points[q].separation) < tolerance &&
               a.points[p].feature == b.points[q].feature;
    };
    if (a.count != b.count) return false;
    if (a.count == 1) return same(0, 0);
    return (same(0, 0) && same(1, 1)) || (same(0, 1) && same(1, 0));
}

template <class T>
bool sameBits(const T& a, const T& b) {
    return std::memcmp(&a, &b, sizeof(T)) == 0;
}

/// How much two manifolds may differ.
struct Slack {
    float separation = 0;  ///< some twenty roundings of numbers up to the sizes [m]
    float place = 0;       ///< of points [m]
    float cosine = 1;      ///< between the normals
};

struct Agreement {
    int touching = 0;
    int otherwise = 0;  ///< of those: along another face, or at other points
};

inline void compare(const Manifold& one, const Manifold& side, const Slack& slack, Agreement& agreement) {
    if (one.count == 0 || side.count == 0) {  // both, or one of them by a rounding
        const Manifold& found = one.count > 0 ? one : side;
        if (found.count > 0) CHECK(std::fabs(nearestOf(found) - contactMargin) < slack.separation);
        return;
    }
    ++agreement.touching;
    CHECK(std::fabs(nearestOf(one) - nearestOf(side)) < slack.separation);
    if (one.normal.dot(side.normal) < slack.cosine || !samePoints(one, side, slack.place)) ++agreement.otherwise;
}

}  // namespace plumb::test
