// SPDX-License-Identifier: MIT
// How does the solver see contacts? In batches whose lanes touch different bodies, so that all lanes may go at once.
#pragma once
#include <array>
#include <cstdint>

namespace plumb {

inline constexpr int batchLanes = 16;

template <class T>
using Lanes = std::array<T, batchLanes>;

/// One point of each lane's manifold. Anchors are components along the contact's normal and tangent, times rho of their
/// body (see SolverVelocity). Impulses are those of half a sub-step.
struct alignas(64) PointLanes {
    Lanes<float> anchorNormalA, anchorTangentA;  ///< from A's centre of mass
    Lanes<float> anchorNormalB, anchorTangentB;  ///< from B's
    Lanes<float> startSeparation;                ///< at the step's start [m]
    Lanes<float> separation;                     ///< where the bodies are now [m]
    Lanes<float> normalMass, tangentMass;        ///< effective masses, 0 for a point that is not there [kg]
    Lanes<float> normalImpulse, tangentImpulse;  ///< [N s]
    Lanes<float> solvedNormal, solvedTangent;    ///< of the half sub-step before the move, while after it is relaxed
    Lanes<float> totalNormal, totalTangent;      ///< over the step so far [N s]
    Lanes<float> bounceSpeed;                    ///< at which the point is to part at the step's end; 0: need not [m/s]
};

struct alignas(64) ContactBatch {
    Lanes<std::uint32_t> bodyA, bodyB;  ///< records of the solver; an empty lane has 0 and 0
    Lanes<float> normalX, normalY;      ///< from A to B
    Lanes<float> friction;
    Lanes<float> roundA, roundB;  ///< radius around the core, times rho: this much of an anchor does not turn
    std::array<PointLanes, 2> points;
};

}  // namespace plumb
