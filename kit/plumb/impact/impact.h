// SPDX-License-Identifier: MIT
// How do two bodies separate after they hit each other at one point?
#pragma once
#include <plumb/math/vec2.h>

namespace plumb {

/// One of the two bodies at the moment of impact. An inverse mass or inertia of 0 means a wall, or a body that does not
/// turn.
struct ImpactSide {
    Vec2 velocity{0, 0};         ///< of the centre of mass [m/s]
    double angularVelocity = 0;  ///< [rad/s]
    double inverseMass = 0;      ///< [1/kg]
    double inverseInertia = 0;   ///< about the centre of mass [1/(kg m^2)]
    Vec2 arm{0, 0};              ///< from the centre of mass to the contact point [m]
};

struct ImpactLaw {
    double restitution = 1;  ///< 0 to 1 [-]
    double friction = 0;     ///< Coulomb coefficient, >= 0 [-]
    /// Sum of both surfaces' speeds, as of conveyor belts: friction acts against the slip plus this speed [m/s].
    double surfaceSpeed = 0;
};

/// How impulses at the point change the relative velocity of the two: (n, t)' = (n, t) + K (jn, jt). It describes
/// bodies of any kind, such as parts of a mechanism.
struct ImpactResponse {
    double normal = 0, coupling = 0, tangent = 0;  ///< K_nn, K_nt = K_tn, K_tt [1/kg]
};

struct ImpactImpulses {
    double normal = 0;   ///< on B along the normal, >= 0 [N s]
    double tangent = 0;  ///< on B along perp(normal) [N s]
    bool sticks = false;
};

struct ImpactResult {
    Vec2 velocityA{0, 0}, velocityB{0, 0};              ///< afterwards [m/s]
    double angularVelocityA = 0, angularVelocityB = 0;  ///< afterwards [rad/s]
    double normalImpulse = 0;   ///< on B along the normal, >= 0; 0 when they were not approaching [N s]
    double tangentImpulse = 0;  ///< on B along perp(normal) [N s]
    bool sticks = false;        ///< the contact point ended without slip
};

/// Newton's law of impact with Coulomb friction; normal is a unit vector from A to B. With u the velocity of B's point
/// relative to A's, n along the normal and t along perp(normal):
///   u' = u + K (jn, jt),  u'_n = -e u_n,  u'_t = -s if |jt| <= f jn there, else |jt| = f jn against the slip
/// u, u' before and after, s surface speed [m/s], jn, jt impulses [N s], e restitution [-], f friction [-], K inverse
/// mass matrix at the point [1/kg]: its coupling K_nt is not 0 when an arm is not along the normal. The two laws
/// together could then increase the energy, as seen from the surface that moves (Kane's paradox); in that case jt is
/// reduced until the energy does not increase, and is less than either law says.
/// When the points do not approach each other, or a velocity is not finite or the normal NaN, nothing changes.
/// Throws std::invalid_argument on restitution outside 0 to 1, on negative or NaN friction (infinite friction never
/// slips), on a surface speed that is not finite, on an inverse mass or inertia that is negative or not finite, on an
/// arm that is not finite, on a normal whose length is not 1 to 1e-5, and where masses and speeds give an impulse that
/// is not finite. Source: Routh, "Dynamics of a System of Rigid Bodies", part 1, 1905, ch. 5; Kane and Levinson,
/// "Dynamics", 1985, 5.9. Exact to rounding. Tests: "100,000 random impacts obey momentum, restitution and friction,
/// and gain no energy", "10,000 impacts on a belt are those on a wall that moves as the belt's surface does"
ImpactResult impact(const ImpactSide& a, const ImpactSide& b, const Vec2& normal, const ImpactLaw& law);

/// The same law for two things whose response at the point is known. approach: -u_n, > 0; slip: u_t [m/s]. response:
/// K_nn > 0. Unlike impact, it does not check its input.
ImpactImpulses impactImpulses(const ImpactResponse& response, double approach, double slip, const ImpactLaw& law);

}  // namespace plumb
