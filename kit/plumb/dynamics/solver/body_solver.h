// SPDX-License-Identifier: MIT
// How do bodies move within a sub-step?
#pragma once
#include <cstddef>

#include <plumb/dynamics/bodies/solver_body.h>

namespace plumb {

/// sin a and cos a - 1 of an angle turned within a step.
struct SinCosMinus1 {
    float sin, cosMinus1;
};
/// Beyond smallTurn, where the series of the lanes no longer holds.
SinCosMinus1 turnedFar(float angle);
inline constexpr float smallTurn = 0.5f;  ///< [rad]

struct BodySolver {
    /// Moves bodies on by h [s]. list: their slots, a multiple of batchLanes of them, filled up with slot 0.
    void (*move)(const std::uint32_t* list, std::size_t count, const SolverBodies& bodies, float h);
};

template <int W>
struct WideBodySolver {
    static const BodySolver code;
};

/// For at most so many lanes, as the machine can.
const BodySolver& bodySolver(int lanes);

/// What half a sub-step of forces and of the last contact impulses does to velocities. After the first time, what the
/// contacts have changed since is what they are given from then on.
void kickBodies(const std::uint32_t* list, std::size_t count, const SolverBodies& bodies, bool first);
/// Remembers the velocities as they are before the contacts are solved.
void markBodies(const std::uint32_t* list, std::size_t count, const SolverBodies& bodies);

}  // namespace plumb
