// SPDX-License-Identifier: MIT
// Which impulse does an explosion give to a body?
#pragma once
#include <span>

#include <plumb/math/vec2.h>

namespace plumb {

struct Explosion {
    Vec2 center{0, 0};            ///< [m]
    double radius = 1;            ///< R: full strength up to this distance, >= 0 [m]
    double falloff = 1;           ///< f: width beyond the radius over which the strength falls to 0, >= 0 [m]
    double impulsePerLength = 1;  ///< j: per length of the body's width; negative pulls inwards [N s/m]
};

/// A body that is hit.
struct BlastTarget {
    Vec2 nearest{0, 0};       ///< the body's point nearest to the explosion's centre [m]
    Vec2 centerOfMass{0, 0};  ///< used when the explosion is inside of the body [m]
    double width = 1;         ///< w: width as seen from the explosion, >= 0 [m]
};

/// An impulse, and the point at which it acts.
struct Blast {
    Vec2 impulse{0, 0};  ///< [N s]
    Vec2 point{0, 0};    ///< [m]
};

/// J = j w s away from the centre, at the nearest point [N s]
/// s = 1 up to d = R, then 1 - (d - R) / f, 0 from d = R + f on; d distance of the nearest point [m]
/// If the explosion is inside of the body, the impulse acts at the centre of mass, away from the explosion's centre; if
/// the two coincide there is none. Source: the law of b2World_Explode of Box2D 3. Throws std::invalid_argument on a
/// radius, falloff or width that is negative or not finite, and on a strength that is not finite. Test: "a blast of 3 N
/// s/m at half its falloff gives 2 m of width 3 N s"
Blast blastOn(const Explosion& explosion, const BlastTarget& target);

/// The width of points, each with a radius around it, across a direction [m]: a polygon's corners and its rounding, a
/// capsule's ends and its radius, a circle's centre and its radius. 0 if there are no points, or no direction. Throws
/// std::invalid_argument on a radius that is negative or not finite.
double widthAcross(std::span<const Vec2> points, double radius, const Vec2& direction);

}  // namespace plumb
