// SPDX-License-Identifier: MIT
// How does speed rise and fall between two pauses?
#pragma once
#include <cstdint>

namespace plumb {

enum class Easing : std::uint8_t {
    None,          ///< full speed all the time
    Acceleration,  ///< constant acceleration, full speed, constant deceleration
    SmoothStep,    ///< s = L x^2 (3 - 2 x), x the fraction of the time that has passed
};

struct PathTiming {
    double speed = 1;  ///< the highest, > 0 [m/s]
    Easing easing = Easing::None;
    double acceleration = 1;  ///< of Easing::Acceleration, > 0 [m/s^2]
};

struct Progress {
    double along = 0;  ///< [m]
    double speed = 0;  ///< [m/s]
};

// A motion of length L, > 0, from rest to rest, or without easing at full speed. Throws std::invalid_argument that
// names the field. With v the speed, a the acceleration:
//   None          T = L / v
//   Acceleration  T = L / v + v / a, or 2 sqrt(L / a) where L < v^2 / a and v is not reached
//   SmoothStep    T = 3 L / (2 v): v is met halfway; the acceleration is highest at both ends, 8 v^2 / (3 L)
// Tests: "runs take their closed forms' time: ...", "10,000 runs: distance is the speed's integral, ..."

double timeOf(double length, const PathTiming& timing);  ///< T [s]
/// At a time since its start, limited to 0 to T [s].
Progress progressAt(double length, const PathTiming& timing, double time);

}  // namespace plumb
