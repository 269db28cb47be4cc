// SPDX-License-Identifier: MIT
// Which force and torque do two small magnets exert on each other?
#pragma once
#include <plumb/math/vec2.h>

namespace plumb {

/// A magnet that is small compared with the distance to the next: a dipole in the plane.
struct Dipole {
    Vec2 position{0, 0};  ///< [m]
    Vec2 moment{1, 0};    ///< m, from its south to its north pole [A m^2]
};

struct Magnetism {
    double constant = 1e-7;  ///< K = mu0 / (4 pi), of vacuum to nine digits; a game uses a larger one [N/A^2]
    double softening = 0;    ///< s: below this distance the force hardly grows, >= 0 [m]
};

/// The effect of one magnet on another.
struct MagnetPull {
    Vec2 force{0, 0};   ///< at its position [N]
    double torque = 0;  ///< [N m]
};

/// On B, with d from A to B [m], q = sqrt(d^2 + s^2) [m]:
///   F = 3 K ((mA . mB) d + (mB . d) mA + (mA . d) mB) / q^5 - 15 K (mA . d) (mB . d) d / q^7
///   torque = mB x H,  H = K (3 (mA . d) d / q^5 - mA / q^3)  the field of A there [T]
/// A has the opposite force; its torque is that of magnetPull(law, b, a). Two at the same position have no effect.
/// Source:
/// Yung, Landecker, Villani, "An analytic solution for the force between two magnetic dipoles", Magnetic and
/// Electrical Separation 9, 1998; both are slopes of the energy below. Throws std::invalid_argument on a constant
/// or softening that is negative or not finite. Tests: "two magnets in line pull with 6 K m^2 / r^4, side by side
/// they push with half of it", "two magnets keep their angular momentum, 100,000 times"
MagnetPull magnetPull(const Magnetism& law, const Dipole& a, const Dipole& b);

/// U = -mB . H [J], 0 far apart. Test: "the slope of every potential energy is its force, in 100,000 places each"
double potentialEnergy(const Magnetism& law, const Dipole& a, const Dipole& b);

}  // namespace plumb
