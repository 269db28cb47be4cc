// SPDX-License-Identifier: MIT
// Where is a body that another attracts by the inverse square of the distance?
#pragma once
#include <plumb/math/vec2.h>

namespace plumb::compare {

struct KeplerOrbit {
    double semiMajorAxis = 1;  ///< a, > 0 [m]
    double eccentricity = 0;   ///< e, 0 to 1; 1 falls straight in [-]
    double period = 1;         ///< T, > 0 [s]
};

/// From the focus, x towards the near end.
struct KeplerState {
    Vec2 position{0, 0};  ///< [m]
    Vec2 velocity{0, 0};  ///< [m/s]
};

/// x = a (cos E - e), y = a sqrt(1 - e^2) sin E, E - e sin E = 2 pi t / T, counter-clockwise
/// t time since the near end [s]; E is found by bisection, to rounding. Source: Kepler, "Astronomia nova", 1609.
/// At e = 1 the near end is the focus itself, where the speed is not finite.
/// Test: "an ellipse's closed form obeys the inverse square law, and sweeps even areas"
KeplerState keplerState(const KeplerOrbit& orbit, double time);

}  // namespace plumb::compare
