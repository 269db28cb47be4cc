// SPDX-License-Identifier: MIT
// Where is a pendulum of any amplitude at time t, and how far does one swing that a bullet hits?
#pragma once

namespace plumb::compare {

struct Pendulum {
    double equivalentLength = 1;  ///< L = I_pivot / (m l) [m]
    double gravity = 9.81;        ///< [m/s^2]
    double amplitude = 0.5;       ///< theta when it is released at rest, from straight down, between -pi and pi [rad]
};

struct Swing {
    double angle;            ///< theta [rad]
    double angularVelocity;  ///< [rad/s]
};

/// T = T0 / AGM(1, cos(theta0 / 2)),  T0 = 2 pi sqrt(L / g)
/// T period [s], theta0 amplitude [rad], AGM the arithmetic-geometric mean
/// Source: Carvalhaes, Suppes, "Approximations for the period of the simple pendulum based on the arithmetic-geometric
/// mean", Am. J. Phys. 76 (2008). Exact to rounding.
/// Test: "a pendulum of 1 m swings 1.0399733432 times as long at 45 degrees"
double periodOf(const Pendulum& pendulum);

/// sin(theta / 2) = k sn(w t + K, k),  theta' = 2 k w cn(w t + K, k)
/// k = sin(theta0 / 2) modulus [-], w = sqrt(g / L) [rad/s], K a quarter period of sn [-], sn and cn Jacobi's functions
/// Source: integrate theta'' = -w^2 sin theta once, substitute sin(theta / 2) = k sin phi (Landau, Lifshitz,
/// "Mechanics", section 11, problem 1). sn and cn by descending Landen: Abramowitz, Stegun, 16.4. Error about 1e-14 a
/// period. Test: "a pendulum's closed form solves its equation of motion"
Swing swingAt(const Pendulum& pendulum, double t);

/// The block hangs on parallel rods, so that it does not turn.
struct BallisticPendulum {
    double bullet = 0.01;   ///< m [kg]
    double block = 1;       ///< M [kg]
    double speed = 100;     ///< v of the bullet, horizontal [m/s]
    double length = 1;      ///< of the rods [m]
    double gravity = 9.81;  ///< [m/s^2]
};

/// h = (m v / (m + M))^2 / (2 g) [m].
/// Source: Robins 1742; momentum is kept while the bullet stops in the block, and energy after that.
/// Test: "a bullet of 10 g at 100.04 m/s lifts a block of 1 kg by 5 cm"
double riseOf(const BallisticPendulum& pendulum);

/// acos(1 - h / l), the angle of the rods from straight down [rad]. Holds: h < 2 l.
double amplitudeOf(const BallisticPendulum& pendulum);

}  // namespace plumb::compare
