// SPDX-License-Identifier: MIT
// Where does a shell leave a mortar, and how fast?
#pragma once
#include <games/artillery/rules.h>
#include <plumb/dynamics/body_def.h>

namespace plumb::games::artillery {

/// All values are whole steps, so a player with buttons can set exactly the intended aim.
struct Aim {
    int facing = 1;       ///< 1: to the right, -1: to the left
    int elevation = 450;  ///< above the horizontal, lowestAim to highestAim [tenths of a degree]
    int charge = 60;      ///< 0 to fullCharge
    friend bool operator==(const Aim&, const Aim&) = default;
};
inline constexpr int lowestAim = -300, highestAim = 900;

Vec2 directionOf(const Aim& aim);
double speedOf(int charge);              ///< [m/s]
int chargeFor(double speed);             ///< the nearest possible charge
Vec2 muzzleFrom(const Vec2& direction);  ///< the muzzle, relative to the gunner's centre [m]

/// The shell at the moment of firing; gunner: the gunner's centre [m].
BodyDef shellDef(const Vec2& gunner, const Aim& aim, const Weapon& weapon);

inline constexpr double shellRadius = 0.2;  ///< [m]
inline constexpr double shellMass = 1;      ///< [kg]

}  // namespace plumb::games::artillery
