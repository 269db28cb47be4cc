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
/// For angles beyond smallTurn, where the series of the lanes is not exact enough.
SinCosMinus1 turnedFar(float angle);
inline constexpr float smallTurn = 0.5f;  ///< [rad]

/// A body that may have moved far for its size in a sub-step, and its displacement before that.
struct FastBody {
    std::uint32_t body = 0;
    float x = 0, y = 0, angle = 0;
};

struct BodySolver {
    /// Moves bodies by h [s]. list: their slots; count is a multiple of batchLanes, filled up with slot 0. Writes the
    /// fast ones (see SolverTurn) to a list that has room for all, and returns how many they are.
    std::size_t (*move)(const std::uint32_t* list, std::size_t count, const SolverBodies& bodies, float h,
                        FastBody* fast);
};

template <int W>
struct WideBodySolver {
    static const BodySolver code;
};

/// The widest solver that this machine supports, with at most this number of lanes.
const BodySolver& bodySolver(int lanes);

/// Changes velocities by the forces of half a sub-step and by the last contact impulses (the warm start). After the
/// first call in a step, the changes that contacts have made since the last call are added to the warm start.
void kickBodies(const std::uint32_t* list, std::size_t count, const SolverBodies& bodies, bool first);
/// Stores the velocities before the contacts are solved.
void markBodies(const std::uint32_t* list, std::size_t count, const SolverBodies& bodies);

}  // namespace plumb
