// SPDX-License-Identifier: MIT
// How does a swing of one radian a second move?
#pragma once
#include <Eigen/Core>

namespace plumb::test {

using Vector2 = Eigen::Vector2d;

inline Vector2 oscillator(double, const Vector2& y) {
    return {y[1], -y[0]};
}

}  // namespace plumb::test
