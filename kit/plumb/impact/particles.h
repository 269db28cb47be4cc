// SPDX-License-Identifier: MIT
// How do particles separate after a collision with each other, with a wall, and in a whole row?
#pragma once
#include <span>
#include <vector>

#include <plumb/impact/impact.h>

namespace plumb {

struct Particle {
    double mass = 1;      ///< > 0; infinite is a wall [kg]
    Vec2 velocity{0, 0};  ///< [m/s]
};

/// impact() of two particles, which cannot turn; normal is a unit vector from A to B. Throws std::invalid_argument as
/// impact() does, on a mass that is not positive and on a velocity that is not finite, as all functions here. Test:
/// "equal particles that meet 30 degrees off the line part as the lecture says"
ImpactResult collideParticles(const Particle& a, const Particle& b, const Vec2& normal, const ImpactLaw& law = {});

/// impact() of a particle that hits a wall at rest: its velocity afterwards [m/s]. normal: a unit vector out of the
/// wall. Along the normal v' = -e v; along the wall friction reduces the speed by up to f (1 + e) |v|, but not below 0.
Vec2 bounceOffWall(const Vec2& velocity, const Vec2& normal, const ImpactLaw& law = {});

/// A particle that moves on a line.
struct LineParticle {
    double mass = 1;      ///< > 0; infinite is a wall [kg]
    double velocity = 0;  ///< [m/s]
};

struct LineImpact {
    double velocityA = 0, velocityB = 0;  ///< afterwards [m/s]
    double impulse = 0;                   ///< on B, >= 0; 0 when they were not approaching [N s]
};

/// vA' = (P - e mB (vA - vB)) / M,  vB' = (P + e mA (vA - vB)) / M,  for A to the left of B
/// P = mA vA + mB vB momentum [N s], M = mA + mB [kg], e restitution, 0 to 1 [-].
/// Source: Newton, "Principia", 1687, scholium to the laws. Test: "on a line, 2 kg at 3 m/s and 1 kg at -1 m/s part
/// at 1/3 and 13/3 m/s, or at e = 0.5 at 1 and 3"
LineImpact collideInLine(const LineParticle& a, const LineParticle& b, double restitution = 1);

struct RowImpact {
    std::vector<double> velocities = {};  ///< afterwards, from left to right [m/s]
    int impacts = 0;                      ///< of two at a time [-]
    bool parted = true;                   ///< false when maxImpacts was not enough
};

/// A row of particles that touch, from left to right, as in Newton's cradle or stacked balls that are dropped: they
/// collide two at a time, in sweeps from the left, until no two approach each other by more than 1e-12 of the largest
/// speed. For e < 1 that may take very many ever weaker impacts: maxImpacts at most.
/// Source: Herrmann, Seitz, "How does the ball-chain work?", Am. J. Phys. 50, 1982; as if there were gaps between.
/// Throws std::invalid_argument as collideInLine does, whether that particle collides or not, and on a maxImpacts that
/// is negative. Tests: "in a cradle of five as many balls go out as come in", "three balls dropped on each other, each
/// far lighter, rise 49 times as high"
RowImpact collideRow(std::span<const LineParticle> row, double restitution = 1, int maxImpacts = 100'000);

}  // namespace plumb
