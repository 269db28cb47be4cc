// SPDX-License-Identifier: MIT
// What mass does a joint's spring move, where an engine gives springs as a frequency of it?
#pragma once
#include <compare/engine/joint_geometry.h>
#include <plumb/dynamics/joint_def.h>

namespace plumb::compare {

/// 1 / (1/mA + 1/mB + (rA x u)^2 / IA + (rB x u)^2 / IB), as the bodies stand at the start.
/// m masses [kg], I moments of inertia [kg m^2], r from the centre of mass to the anchor [m], u a unit vector [-]
/// Of what does not move, 1/m and 1/I are 0. Source: virtual work; as engines of impulses have it.
double effectiveMass(const Scene& scene, const JointGeometry& joint, const Vec2& direction);

/// 1 / (1/IA + 1/IB) [kg m^2].
double effectiveInertia(const Scene& scene, const JointGeometry& joint);

/// A spring as such engines have it.
struct Frequency {
    double hertz = 0;         ///< sqrt(k / m) / (2 pi) [Hz]
    double dampingRatio = 0;  ///< c / (2 sqrt(k m)) [-]
};

/// The inverse of springOf. A spring of no stiffness that damps gets a frequency of 1e-4 Hz, which nobody sees: such
/// engines have no other damper. Of no mass, 0.
Frequency frequencyOf(const Spring& spring, double mass);

}  // namespace plumb::compare
