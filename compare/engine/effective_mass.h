// SPDX-License-Identifier: MIT
// Which mass does a joint's spring move? Some engines define a spring by the frequency of this mass.
#pragma once
#include <compare/scene/joint_geometry.h>
#include <plumb/dynamics/joint_def.h>

namespace plumb::compare {

/// 1 / (1/mA + 1/mB + (rA x u)^2 / IA + (rB x u)^2 / IB), with the bodies' places at the start.
/// m masses [kg], I moments of inertia [kg m^2], r from the centre of mass to the anchor [m], u a unit vector [-]
/// For a body that does not move, 1/m and 1/I are 0. Source: virtual work; impulse-based engines use the same.
double effectiveMass(const Scene& scene, const JointGeometry& joint, const Vec2& direction);

/// 1 / (1/IA + 1/IB) [kg m^2].
double effectiveInertia(const Scene& scene, const JointGeometry& joint);

/// A spring as such engines define it.
struct Frequency {
    double hertz = 0;         ///< sqrt(k / m) / (2 pi) [Hz]
    double dampingRatio = 0;  ///< c / (2 sqrt(k m)) [-]
};

/// The inverse of springOf. A damper without stiffness gets a frequency of 1e-4 Hz, which is too low to see: such
/// engines have no other damper. 0 if the mass is 0.
Frequency frequencyOf(const Spring& spring, double mass);

}  // namespace plumb::compare
