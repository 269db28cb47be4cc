// SPDX-License-Identifier: MIT
// What slides on its lower side?
#pragma once
#include <cmath>
#include <numbers>
#include <vector>

#include <plumb/plumb.h>

namespace plumb::test {

inline constexpr Material smooth{.friction = 0};

struct Slider {
    const char* name = "";
    ShapeDef shape;
    double below = 0;  ///< from its centre to what it rests on [m]
};

/// With one of its six sides below.
inline ShapeDef hexagon(double radius, const Material& material = {}) {
    std::vector<Vec2> corners;
    for (int i = 0; i < 6; ++i) {
        const double angle = (2 * i + 1) * std::numbers::pi / 6 - std::numbers::pi / 2;
        corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    return polygon(corners, material);
}

/// Of kinds 0 to 3, half as wide as size.
inline Slider sliderOf(int kind, double size, const Material& material = {}) {
    switch (kind) {
        case 0: return {"disc", circle(size, material), size};
        case 1: return {"box", box({size, 0.8 * size}, material), 0.8 * size};
        case 2: return {"capsule", capsule({-size, 0}, {size, 0}, size / 2, material), size / 2};
        default: return {"hexagon", hexagon(size, material), size * std::cos(std::numbers::pi / 6)};
    }
}

}  // namespace plumb::test
