// SPDX-License-Identifier: MIT
// Which gravity and which time step do most tests of worlds have?
#pragma once

namespace plumb::test {

inline constexpr double g = 9.81;
inline constexpr double dt = 1.0 / 60;

}  // namespace plumb::test
