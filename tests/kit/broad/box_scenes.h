// SPDX-License-Identifier: MIT
// Which sets of boxes put a broad phase to the test?
#pragma once
#include <cmath>
#include <limits>
#include <vector>

#include <plumb/math/random.h>
#include <plumb/shapes/aabb.h>

namespace box_scenes {

using plumb::Aabb;
using plumb::Random;
using plumb::Vec2;

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

using Boxes = std::vector<Aabb>;

inline Aabb around(const Vec2& center, double halfWidth, double halfHeight) {
    return {center - Vec2(halfWidth, halfHeight), center + Vec2(halfWidth, halfHeight)};
}

inline Aabb squareAround(const Vec2& center, double half) {
    return around(center, half, half);
}

inline Vec2 somewhere(Random& random, double size) {
    return {random.uniform(-size, size), random.uniform(-size, size)};
}

inline Aabb evenBox(Random& random) {
    return around(somewhere(random, 20), random.uniform(0, 1), random.uniform(0, 1));
}

/// One box of a kind of scene.
struct Kind {
    const char* name;
    Aabb (*box)(Random& random);
};

inline const Kind kinds[] = {
    {"even", evenBox},
    {"crowded", [](Random& r) { return around(somewhere(r, 2), 0.3, 0.3); }},
    {"a grid whose cells touch", [](Random& r) { return around(Vec2(r.integer(0, 30), r.integer(0, 30)), 0.5, 0.5); }},
    {"points on a grid", [](Random& r) { return around(Vec2(r.integer(0, 9), r.integer(0, 9)), 0, 0); }},
    {"a row", [](Random& r) { return around(Vec2(r.uniform(-50, 50), 3), 0.2, 0.2); }},
    {"a column", [](Random& r) { return around(Vec2(-7, r.uniform(0, 100)), 0.5, 0.1); }},
    {"one point", [](Random&) { return around(Vec2(1, 2), 0.5, 0.5); }},
    {"sizes from 1e-4 to 1e4",
     [](Random& r) { return around(somewhere(r, 100), std::exp(r.uniform(-9, 9)), std::exp(r.uniform(-9, 9))); }},
    {"a few huge ones",
     [](Random& r) { return around(somewhere(r, 50), r.integer(0, 20) ? 0.2 : 100, r.integer(0, 20) ? 0.2 : 1e3); }},
    {"clusters 100 km apart",
     [](Random& r) { return around(somewhere(r, 5) + 1e5 * Vec2(r.integer(-1, 1), r.integer(-1, 1)), 0.3, 0.3); }},
    {"far from the origin", [](Random& r) { return around(somewhere(r, 20) + Vec2(1e9, -3e9), 0.5, 0.5); }},
    {"gaps that no float tells",
     [](Random& r) { return around(Vec2(1e6 + r.integer(0, 5) * 2e-9, r.integer(0, 5)), 0.9e-9, 0.4); }},
    {"one at 1e300",
     [](Random& r) { return r.integer(0, 99) ? evenBox(r) : around(Vec2(1e300, -1e300), 1, r.uniform(0, 1e300)); }},
    {"beyond floats", [](Random& r) { return around(somewhere(r, 1e305), 1e304, 1e304); }},
    {"smaller than floats", [](Random& r) { return around(somewhere(r, 1e-50), 1e-51, 1e-51); }},
    {"denormal", [](Random& r) { return around(somewhere(r, 1e-318), 1e-319, 1e-319); }},
    {"towards 0 by halves",
     [](Random& r) { return around(Vec2(std::exp2(-r.integer(0, 1000)), std::exp2(-r.integer(0, 60))), 1e-19, 1e-3); }},
    {"half planes, lines and the whole plane",
     [](Random& r) {
         Aabb box = evenBox(r);
         for (const int side : {0, 1}) {
             if (r.integer(0, 9) == 0) box.lower[side] = r.integer(0, 1) ? -infinity : infinity;
             if (r.integer(0, 9) == 0) box.upper[side] = r.integer(0, 9) ? infinity : -infinity;
         }
         return box;
     }},
    {"no numbers",
     [](Random& r) {
         Aabb box = evenBox(r);
         if (r.integer(0, 3) == 0) (r.integer(0, 1) ? box.lower : box.upper)[r.integer(0, 1)] = notANumber;
         return box;
     }},
    {"one giant among small ones",
     [](Random& r) {
         return r.integer(0, 99) ? around(somewhere(r, 30), 0.2, 0.2) : around({0, 0}, 1e4, 1e3);
     }},
    {"long lines",
     [](Random& r) {
         const double half = r.uniform(0, 40);
         return r.integer(0, 1) ? around(somewhere(r, 20), half, 0.01) : around(somewhere(r, 20), 0.01, half);
     }},
    {"clusters, and clusters of clusters",
     [](Random& r) {
         Vec2 place(0, 0);
         for (double size = 1e4; size > 0.1; size *= 0.01) place += size * Vec2(r.integer(0, 2), r.integer(0, 2));
         return around(place + somewhere(r, 1), 0.2, 0.2);
     }},
    {"alike, a hair apart",
     [](Random& r) {
         const double hair = 0x1p-52;
         return around(Vec2(r.integer(0, 20) * (1 + hair * r.integer(-2, 2)), r.integer(0, 20)), 0.5, 0.5);
     }},
    {"turned inside out", [](Random& r) { return around(somewhere(r, 10), r.uniform(-0.5, 1), r.uniform(-0.5, 1)); }},
};

inline Boxes sceneOf(const Kind& kind, int count, Random& random) {
    Boxes boxes;
    for (int i = 0; i < count; ++i) boxes.push_back(kind.box(random));
    return boxes;
}

}  // namespace box_scenes
