// SPDX-License-Identifier: MIT
// When does a dropped ball come to rest, and how far has it travelled up and down?
#pragma once
#include <optional>

namespace plumb {

struct DroppedBall {
    double height = 1;         ///< h, from which it is dropped, >= 0 [m]
    double restitution = 0.8;  ///< e, 0 to 1 [-]
    double gravity = 9.81;     ///< g, > 0 [m/s^2]
};

struct BouncesToRest {
    double time = 0;      ///< from the drop [s]
    double distance = 0;  ///< total distance, down and up and down [m]
};

/// T = sqrt(2 h / g) (1 + e) / (1 - e),  D = h (1 + e^2) / (1 - e^2); empty where e = 1: it never comes to rest.
/// T time [s], D distance [m]. Source: textbook; the geometric series of flights, each e times as long and e^2
/// times as high as the one before. Throws std::invalid_argument on numbers that are not as above.
/// Test: "a ball dropped from 1 m at e = 0.8 rests after 4.0637127689 s and 4.5555555556 m"
std::optional<BouncesToRest> bouncesToRest(const DroppedBall& ball);

/// The time at which it touches the floor for the n-th time [s]: sqrt(2 h / g) (1 + 2 (e + e^2 + ... + e^(n - 1))); n =
/// 1 is the end of the drop. Throws std::invalid_argument also on n < 1.
/// Test: "flight after flight, a ball touches the floor and turns where the series says"
double bounceTime(const DroppedBall& ball, int n);

/// The height to which it rises after the n-th bounce [m]: h e^(2 n); n = 0 is the drop.
double bounceHeight(const DroppedBall& ball, int n);

}  // namespace plumb
