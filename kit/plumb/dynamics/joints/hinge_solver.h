// SPDX-License-Identifier: MIT
// How are plain hinges of swept islands solved, W at a time?
//
// No two lanes of a batch share a body that can be pushed. Each lane solves, before the sub-step h (correct),
//   K L = -s (vB - vA + b d - h/2 (wB^2 rB - wA^2 rA)) - i L0,   after it   K L = -(vB - vA)
// and L + L0 is its impulse from then on. v velocities of the anchors [m/s], d the gap between them [m], r arms [m], w
// angular velocities [rad/s], K effective inverse mass, from an impulse to vB - vA [1/kg], L0 the impulse so far [N s],
// b, s, i bias rate, mass scale and impulse scale (see softness.h).
#pragma once
#include <cstddef>

#include <plumb/collide/lanes/body_place.h>
#include <plumb/dynamics/bodies/softness.h>
#include <plumb/dynamics/bodies/solver_body.h>

namespace plumb {

struct alignas(64) HingeBatch {
    Lanes<std::uint32_t> bodyA, bodyB;                ///< slots of the bodies; an empty lane has 0 and 0
    Lanes<float> localXA, localYA, localXB, localYB;  ///< anchors, in the bodies' frames [m]
    Lanes<float> startXA, startYA, startXB, startYB;  ///< arms at the step's start [m]
    Lanes<float> gapX, gapY;                          ///< from A's anchor to B's, at the step's start [m]
    Lanes<float> inverseGyrationA, inverseGyrationB;  ///< of the bodies (see SolverVelocity)
    Lanes<float> impulseX, impulseY;                  ///< of half a sub-step, on B [N s]
    Lanes<float> totalX, totalY;                      ///< over the step so far [N s]
};

struct HingePass {
    float step = 0;       ///< h [s]
    bool correct = true;  ///< before the sub-step: closes the gap too
    float fastest = 0;    ///< greatest speed at which a gap is closed [m/s]
    Softness soft;
};

/// The same three functions for each number of lanes, with bitwise equal results.
struct HingeSolver {
    void (*prepare)(HingeBatch* batches, std::size_t count, const BodyPlace* places);
    /// Applies the impulses of the previous half sub-step as a first guess.
    void (*warmStart)(const HingeBatch* batches, std::size_t count, const SolverBodies& bodies);
    void (*solve)(HingeBatch* batches, std::size_t count, const SolverBodies& bodies, const HingePass& pass);
};

template <int W>
struct WideHingeSolver {
    static const HingeSolver code;
};

/// The widest solver that this machine supports, with at most this number of lanes.
const HingeSolver& hingeSolver(int lanes);

}  // namespace plumb
