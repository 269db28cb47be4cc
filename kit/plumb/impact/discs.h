// SPDX-License-Identifier: MIT
// How do two discs separate after a collision, and a disc from a wall, with spin and friction?
#pragma once
#include <plumb/impact/impact.h>

namespace plumb {

struct Disc {
    Vec2 position{0, 0};         ///< of its centre [m]
    double radius = 0.5;         ///< > 0 [m]
    double mass = 1;             ///< > 0; infinite: it neither moves nor turns [kg]
    double inertiaRatio = 0.5;   ///< k = I / (m r^2): 1/2 for a full disc, 1 for a ring, 2/5 for a ball, > 0 [-]
    Vec2 velocity{0, 0};         ///< [m/s]
    double angularVelocity = 0;  ///< [rad/s]
};

/// impact() at the point where they touch, along the line of their centres; the discs are assumed to touch. If their
/// centres coincide there is no such line: nothing changes. Where the slip between them ends, the tangential impulse is
/// slip times m k / (2 (1 + k)) for two equal discs: a sixth of the mass for full discs.
/// Throws std::invalid_argument as impact() does, on a radius, mass or inertia ratio that is not positive, and on a
/// position or a velocity that is not finite. Tests: "equal discs that meet 30 degrees off the line of centres part as
/// the lecture says", "two alike discs that graze pass on slip by a sixth of their mass"
ImpactResult collideDiscs(const Disc& a, const Disc& b, const ImpactLaw& law);

struct ImpactWall {
    Vec2 normal{0, 1};    ///< a unit vector out of the wall [-]
    Vec2 velocity{0, 0};  ///< of its surface, as of a lift or a conveyor belt [m/s]
};

/// impact() of a wall, which is A, and a disc, which is B, where the disc touches it. For a wall at rest, along it:
///   jt = m s k / (1 + k), which ends the slip, where that is at most f jn; else jt = f jn against the slip
/// s slip at the point [m/s], jn = (1 + e) m |vn| impulse along the normal [N s], f friction [-]. k / (1 + k) is a
/// third for a full disc, 2/7 for a ball.
/// Source: Routh, "Dynamics of a System of Rigid Bodies", part 1, 1905, ch. 5; Brach, "Mechanical Impact
/// Dynamics", 1991. Tests: "a disc that comes down at (4, -3) m/s rolls off at friction 0.5, slips at 0.2,
/// and the threshold is 8/27", "what ends the slip is a third of it for a disc, 2/7 for a ball, a half for a ring"
ImpactResult collideWithWall(const Disc& disc, const ImpactWall& wall, const ImpactLaw& law);

}  // namespace plumb
