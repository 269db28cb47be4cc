// SPDX-License-Identifier: MIT
// Which force does a fluid exert on a floating or submerged body?
#pragma once
#include <span>

#include <plumb/math/vec2.h>

namespace plumb {

/// Its surface is perpendicular to its gravity.
struct Fluid {
    double density = 1000;   ///< rho, per area, as all densities in two dimensions, >= 0 [kg/m^2]
    Vec2 surface{0, 0};      ///< any point of the surface [m]
    Vec2 gravity{0, -9.81};  ///< g [m/s^2]
};

/// The part of an outline that lies below the surface.
struct Submerged {
    double area = 0;      ///< A [m^2]
    Vec2 centroid{0, 0};  ///< of that part [m]; the origin when there is none
    double depth = 0;     ///< D, of the centroid below the surface [m]
};

/// By integrals around the submerged part, over lines and arcs: the surface itself contributes nothing to them.
/// corners: counter-clockwise; one is a circle's centre, two are the ends of a capsule. radius >= 0: the outline is
/// offset outwards by it [m]; the corners must then be convex. Without a radius any simple polygon is allowed.
/// Source: Green, 1828: A = -int y dx, A x = -int x y dx, A y = -int y^2 / 2 dx. Exact to rounding; a part of less than
/// 1e-12 of the size squared counts as none. Throws std::invalid_argument on a radius or density that is negative or
/// not finite, on corners, a surface or a gravity that are not finite, and on corners that turn to the right where
/// there is a radius. Without gravity nothing is submerged. Tests: "areas under water are those of the polygon that is
/// left, in 100,000 places", "rounded areas under water are those of 400 pieces a corner, in 10,000 places", "a
/// circle's part under water is a circular segment"
Submerged submergedPart(std::span<const Vec2> corners, double radius, const Fluid& fluid);

/// F = -rho A g [N], at the centroid: its torque about a point p is cross(centroid - p, F). Source: Archimedes.
/// Tests: "a box of half the density of water floats half sunk", "a square bar floats upright at a
/// density of 0.2, and on its edge at 0.3"
Vec2 buoyancyForce(const Fluid& fluid, const Submerged& part);

/// U = rho |g| A D [J]: the work of lifting the displaced fluid to the surface. Its derivatives with respect to
/// translation and rotation are the force and the torque. Test: "the slope of every potential energy is its force, in
/// 100,000 places each"
double potentialEnergy(const Fluid& fluid, const Submerged& part);

/// As submergedPart, for input that was checked before.
Submerged submergedPartOf(std::span<const Vec2> corners, double radius, const Fluid& fluid);

}  // namespace plumb
