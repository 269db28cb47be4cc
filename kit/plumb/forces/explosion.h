// SPDX-License-Identifier: MIT
// How hard does an explosion hit a body?
#pragma once
#include <span>

#include <plumb/math/vec2.h>

namespace plumb {

struct Explosion {
    Vec2 center{0, 0};            ///< [m]
    double radius = 1;            ///< R: as far as this it hits in full, >= 0 [m]
    double falloff = 1;           ///< f: over this width beyond the radius it fades to nothing, >= 0 [m]
    double impulsePerLength = 1;  ///< j: of a body's width across the blast; negative draws in [N s/m]
};

/// What stands in the way.
struct BlastTarget {
    Vec2 nearest{0, 0};       ///< the body's point nearest to the explosion's centre [m]
    Vec2 centerOfMass{0, 0};  ///< from which it is hit when the explosion is within the body [m]
    double width = 1;         ///< w: as seen from the explosion, >= 0 [m]
};

/// An impulse, and where it acts.
struct Blast {
    Vec2 impulse{0, 0};  ///< [N s]
    Vec2 point{0, 0};    ///< [m]
};

/// J = j w s away from the centre, at the nearest point [N s]
/// s = 1 as far as d = R, then 1 - (d - R) / f, none from d = R + f on; d distance of the nearest point [m]
/// A body around the centre is hit at its centre of mass, away from the explosion's; one whose centre of mass is
/// just there is not pushed. Source: the law of b2World_Explode of Box2D 3. Throws
/// std::invalid_argument on a radius, falloff or width that is negative or not finite, and on a strength that is
/// not finite. Test: "a blast of 3 N s/m at half its falloff gives 2 m of width 3 N s"
Blast blastOn(const Explosion& explosion, const BlastTarget& target);

/// How wide points, each with a radius around it, are across a direction [m]: a polygon's corners and its
/// rounding, a capsule's ends and its radius, a circle's centre and its radius. 0 for no points, or no direction.
/// Throws std::invalid_argument on a radius that is negative or not finite.
double widthAcross(std::span<const Vec2> points, double radius, const Vec2& direction);

}  // namespace plumb
