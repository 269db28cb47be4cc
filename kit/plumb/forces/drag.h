// SPDX-License-Identifier: MIT
// How do drag and wind act on a moving body?
#pragma once
#include <plumb/math/vec2.h>

namespace plumb {

/// F = -(k + c |u|) u,  u = v - w
/// F force [N], v velocity [m/s], w wind [m/s], k, c as below. The linear term is for slow or small objects in a
/// viscous fluid (Stokes), the quadratic term for all others (Newton, "Principia", 1687, book 2).
struct Drag {
    double linear = 0;     ///< k, >= 0 [kg/s]
    double quadratic = 0;  ///< c, >= 0 [kg/m]
    Vec2 wind{0, 0};       ///< w, the velocity of the air [m/s]
};

/// c = rho C A / 2 [kg/m]
/// rho density of the air, 1.2 at sea level [kg/m^3], C drag coefficient, about 0.5 for a ball [-], A frontal area
/// [m^2]; in two dimensions rho is a density per area [kg/m^2], and A a width [m]. Throws std::invalid_argument on a
/// number that is negative or not finite.
double quadraticDrag(double density, double dragCoefficient, double area);

/// Throws std::invalid_argument on a drag that is negative or not finite, as all functions here.
/// Test: "what falls from rest is at 25.748172225 m/s after 3 s, and 41.234527650 m down"
Vec2 dragForce(const Drag& drag, const Vec2& velocity);

/// The speed relative to the air at which drag balances a force F >= 0 [N]:  k v + c v^2 = F, so
///   v = 2 F / (k + sqrt(k^2 + 4 c F)) [m/s],  for c alone sqrt(F / c), for k alone F / k; infinite without drag.
/// Test: "at its terminal speed nothing speeds up or slows down, 100,000 times"
double terminalSpeed(const Drag& drag, double force);

/// The velocity of a mass m > 0 [kg] after a time t >= 0 [s] with drag alone, exactly: u keeps its direction, and
///   u' = u e^(-a t) / (1 + b |u| E),  E = (1 - e^(-a t)) / a, or t where a = 0
/// a = k / m [1/s], b = c / m [1/m]. Source: Bernoulli's equation, s' = -a s - b s^2. However long the time, the
/// direction never reverses. Test: "drag's closed form is where 100,000 fine integrations come out"
Vec2 velocityAfterDrag(const Drag& drag, double mass, const Vec2& velocity, double time);

}  // namespace plumb
