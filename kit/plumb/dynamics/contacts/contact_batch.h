// SPDX-License-Identifier: MIT
// How does the solver see contacts? In batches whose lanes touch different bodies, so that all lanes may go at once.
#pragma once
#include <cstddef>
#include <cstdint>

#include <plumb/dynamics/bodies/batch_lanes.h>

namespace plumb {

/// One point of each lane's manifold. Anchors are components along the contact's normal and tangent, times rho of their
/// body (see SolverVelocity). Impulses are those of half a sub-step.
struct alignas(64) PointLanes {
    Lanes<float> anchorNormalA, anchorTangentA;  ///< from A's centre of mass
    Lanes<float> anchorNormalB, anchorTangentB;  ///< from B's
    Lanes<float> separation;                     ///< where the bodies are now [m]
    Lanes<float> normalMass, tangentMass;        ///< effective masses, 0 for a point that is not there [kg]
    Lanes<float> normalImpulse, tangentImpulse;  ///< [N s]
    Lanes<float> startSeparation;                ///< at the step's start [m]
    Lanes<float> totalNormal, totalTangent;      ///< over the step so far [N s]
    Lanes<float> bounceSpeed;                    ///< at which the point is to part at the step's end; 0: need not [m/s]
};

struct alignas(64) ContactBatch {
    Lanes<std::uint32_t> bodyA, bodyB;  ///< slots of the bodies; an empty lane has 0 and 0
    Lanes<float> normalX, normalY;      ///< from A to B
    Lanes<float> friction;
    PointLanes points[2];
    Lanes<float> roundA, roundB;  ///< radius around the core, times rho: this much of an anchor does not turn
    Lanes<float> surfaceSpeed;    ///< of both surfaces, along the tangent [m/s]
    Lanes<float> rollReach;       ///< resisting torque over normal force [m]
    Lanes<float> rollInverseGyrationA, rollInverseGyrationB;  ///< rho of the bodies
    Lanes<float> rollMass;                                    ///< effective inertia [kg m^2]
    Lanes<float> rollImpulse;                                 ///< of half a sub-step [N m s]
    Lanes<std::int32_t> pushed;                               ///< not 0: the contact has given an impulse in this step
    bool bounces, hasSurfaceSpeed, hasRollingResistance;  ///< some lane may have restitution, a beltSpeed, a rollReach
};

/// Of 64 bytes, before the flags.
inline constexpr std::size_t batchRows = offsetof(ContactBatch, bounces) / (sizeof(float) * batchLanes);

/// Where a point lies on its shapes: what the next step knows it by.
struct alignas(64) ManifoldPointLanes {
    Lanes<float> x, y;            ///< in A's frame, from its centre of mass [m]
    Lanes<std::int32_t> feature;  ///< as in collide/manifold.h
};

/// Is one of a pair a disc, and the other a disc or box? Then which.
inline constexpr std::int32_t noDisc = 0, discFirst = 1, discSecond = 2;

/// Two shapes near each other in each lane, as boxes: all it takes to find where they touch if they are, and else to
/// find that they do not.
struct alignas(64) PairLanes {
    Lanes<std::uint32_t> bodyA, bodyB;                    ///< slots of the bodies; an empty lane has 0 and 0
    Lanes<float> halfXA, halfYA, halfXB, halfYB;          ///< [m]
    Lanes<float> radiusA, radiusB;                        ///< around the boxes [m]
    Lanes<float> centerXA, centerYA, centerXB, centerYB;  ///< from their body's centre of mass [m]
    Lanes<std::int32_t> discs;                            ///< of noDisc, discFirst, discSecond
    Lanes<std::uint32_t> proxyA, proxyB;
};

/// One lane of it, but for the boxes.
struct ShapePair {
    std::uint32_t bodyA = 0, bodyB = 0, proxyA = 0, proxyB = 0;
    double shiftX = 0, shiftY = 0;  ///< of B, in a world that wraps [m]
};
inline ShapePair pairAt(const PairLanes& pairs, std::size_t lane) {
    return {pairs.bodyA[lane], pairs.bodyB[lane], pairs.proxyA[lane], pairs.proxyB[lane], 0, 0};
}
inline constexpr std::size_t pairRows = sizeof(PairLanes) / (sizeof(float) * batchLanes);

/// What lanes keep from step to step of where their shapes touch. Parallel to the batches.
struct alignas(64) ManifoldLanes {
    Lanes<float> restitution;
    Lanes<float> normalX, normalY;  ///< from A to B, in A's frame
    ManifoldPointLanes points[2];
    Lanes<std::int32_t> count;     ///< of points
    Lanes<float> approachSpeed;    ///< at the step's start, of the point that approaches fastest [m/s]
    Lanes<std::int32_t> clear;     ///< 1: it would bounce, and for longer than the step, if it were alone
    Lanes<std::int32_t> touching;  ///< 1: the touch has been reported
};
inline constexpr std::size_t manifoldRows = sizeof(ManifoldLanes) / (sizeof(float) * batchLanes);

}  // namespace plumb
