// SPDX-License-Identifier: MIT
// How are contacts stored for the solver? In batches whose lanes have different dynamic bodies, so that all lanes can
// be solved at the same time.
#pragma once
#include <cstddef>
#include <cstdint>

#include <plumb/collide/lanes/pair_lanes.h>
#include <plumb/dynamics/bodies/solver_body.h>

namespace plumb {

/// One point of each lane's manifold. Anchors are components along the contact's normal and tangent, times the body's
/// rho: its inverse radius of gyration (see SolverVelocity). Impulses are those of half a sub-step.
struct alignas(64) PointLanes {
    Lanes<float> anchorNormalA, anchorTangentA;  ///< from A's centre of mass
    Lanes<float> anchorNormalB, anchorTangentB;  ///< from B's centre of mass
    Lanes<float> separation;                     ///< at the bodies' present places [m]
    Lanes<float> normalMass, tangentMass;        ///< effective masses, 0 if there is no such point [kg]
    Lanes<float> normalImpulse, tangentImpulse;  ///< [N s]
    Lanes<float> startSeparation;                ///< at the step's start [m]
    Lanes<float> totalNormal, totalTangent;      ///< since the step's start [N s]
    Lanes<float> bounceSpeed;                    ///< required parting speed at the step's end; 0: none [m/s]
};

struct alignas(64) ContactBatch {
    Lanes<std::uint32_t> bodyA, bodyB;  ///< slots of the bodies; an empty lane has 0 and 0
    Lanes<float> normalX, normalY;      ///< from A to B
    Lanes<float> friction;
    PointLanes points[2];
    Lanes<float> roundA, roundB;  ///< rounding radius times rho: this part of an anchor does not rotate with the body
    Lanes<float> surfaceSpeed;    ///< sum of both surfaces' speeds along the tangent [m/s]
    Lanes<float> rollingArm;      ///< resisting torque over normal force [m]
    Lanes<float> rollInverseGyrationA, rollInverseGyrationB;  ///< rho of the bodies [1/m]
    Lanes<float> rollMass;                                    ///< effective inertia [kg m^2]
    Lanes<float> rollImpulse;                                 ///< in half a sub-step [N m s]
    Lanes<std::int32_t> pushed;                           ///< not 0: the contact has applied an impulse in this step
    bool bounces, hasSurfaceSpeed, hasRollingResistance;  ///< some lane may have restitution, surfaceSpeed, rollingArm
};

/// Number of rows of 64 bytes before the flags.
inline constexpr std::size_t batchRows = offsetof(ContactBatch, bounces) / (sizeof(float) * batchLanes);

/// Where a point is on its shapes. The next step finds the same point again by this.
struct alignas(64) ManifoldPointLanes {
    Lanes<float> x, y;            ///< in A's frame, from its centre of mass [m]
    Lanes<std::int32_t> feature;  ///< as in collide/manifold_point.h
    /// The mean of the last steps, when the step's length changed last [N].
    Lanes<float> normalForce, tangentForce;
};

/// The part of each lane's manifold that is kept from step to step. Parallel to the batches.
struct alignas(64) ManifoldLanes {
    Lanes<float> restitution;
    Lanes<float> normalX, normalY;  ///< from A to B, in A's frame
    ManifoldPointLanes points[2];
    Lanes<std::int32_t> count;     ///< number of points
    Lanes<float> approachSpeed;    ///< at the step's start, of the point that approaches fastest [m/s]
    Lanes<std::int32_t> clear;     ///< 1: alone, its bounces would last longer than the step
    Lanes<std::int32_t> touching;  ///< 1: the touch has been reported
};
inline constexpr std::size_t manifoldRows = sizeof(ManifoldLanes) / (sizeof(float) * batchLanes);

/// B's place in A's frame.
struct alignas(64) PoseLanes {
    Lanes<float> x, y;      ///< from A's centre of mass to B's [m]
    Lanes<float> cos, sin;  ///< of B's angle minus A's
};

/// Which faces of A and of B meet at the corner where a contact is, and may be covered by the next part of a floor?
/// Each is 0 for none, or 1 and the number of sectors from the contact's normal to the face's (see
/// floors/flush_sides.h). So they stay right while the two bodies turn together.
struct CornerFaces {
    std::uint8_t ofA[2], ofB[2];
};
inline constexpr CornerFaces noFaces{{0, 0}, {0, 0}}, unknownFaces{{255, 255}, {255, 255}};
inline bool isUnknown(const CornerFaces& faces) {
    return faces.ofA[0] == unknownFaces.ofA[0];
}

/// What was known when each lane's shapes were last collided. For contacts that are not of two boxes.
struct alignas(64) KeptLanes {
    PoseLanes pose;               ///< cosine and sine 0: the manifold must not be used again
    Lanes<float> separations[2];  ///< [m]
    Lanes<CornerFaces> faces;     ///< unknownFaces when just collided
    Lanes<std::int32_t> open;     ///< bits, 0 when just collided: not covered since (floorA, floorB); seenBit
};
inline bool isKept(const KeptLanes& kept, std::size_t lane) {
    return kept.pose.cos[lane] != 0 || kept.pose.sin[lane] != 0;
}
inline constexpr std::size_t keptRows = sizeof(KeptLanes) / (sizeof(float) * batchLanes);

}  // namespace plumb
