// SPDX-License-Identifier: MIT
// What are the mass, the centre of mass and the moment of inertia of a shape?
#pragma once
#include <span>

#include <plumb/shapes/shape.h>

namespace plumb {

struct Mass {
    double mass = 0;     ///< [kg]
    Vec2 center{0, 0};   ///< centre of mass, in the body's frame [m]
    double inertia = 0;  ///< about the centre of mass [kg m^2]
};

/// Mass of a shape of uniform density. Throws std::invalid_argument unless the shape is valid for a body, and the
/// density finite and not negative.
/// circle:  m = d pi r^2, I = m r^2 / 2
/// capsule: a rectangle and two half discs, l between their centres: m = d (2 r l + pi r^2),
///          I = d 2 r l (l^2 + 4 r^2) / 12 + d pi r^2 (r^2 / 2 + l^2 / 4 + 4 r l / 3 pi)
/// polygon: sum over triangles (o, p_i, p_i+1) of area a = (p_i x p_i+1) / 2:
///          m = d sum a, c = d sum a (p_i + p_i+1) / 3 / m,
///          I_o = d sum a (p_i.p_i + p_i.p_i+1 + p_i+1.p_i+1) / 6, I = I_o - m c.c
///          rounded: plus a strip of width r along each edge, and a sector of a disc around each corner
/// segment, chain: no area, no mass
/// d density [kg/m^2], r radius [m], p corners relative to o [m]
/// Source: standard; polygon by Green's theorem. Exact to rounding.
/// Test: "mass properties of random polygons match numerical integration"
Mass massOf(const Shape& shape, double density);

/// The mass of several shapes together: masses add, inertia by the parallel axis theorem. Throws std::invalid_argument
/// unless all are finite, and no mass or inertia is negative.
Mass combine(std::span<const Mass> parts);

}  // namespace plumb
