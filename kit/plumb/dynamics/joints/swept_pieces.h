// SPDX-License-Identifier: MIT
// How does a swept island move in sub-steps of its own?
//
// One pass over joints carries an impulse from each joint to its neighbours only, so a wide net needs more passes than
// a small one; and the gap of its joints falls with the square of the sub-step. So a swept island moves in pieces of
// the world's sub-step, as many as it is wide. What changes its velocities in a half of the sub-step (forces, fields,
// the contacts' first guess) is shared out evenly: each half of a piece gets the same part. Contacts see the island at
// the world's sub-steps.
// Test: "swept nets of any width hang with gaps below half a per cent of a link"
#pragma once
#include <span>
#include <vector>

#include <plumb/dynamics/bodies/body_solver.h>
#include <plumb/dynamics/bodies/body_store.h>
#include <plumb/math/detail/arrays.h>
#include <plumb/math/function_ref.h>

namespace plumb {

class SweptPieces {
public:
    /// At the start of a step: for these bodies.
    void begin(std::span<const BodyIndex> list, const BodyStore& bodies, int pieces);
    int count() const { return pieces_; }

    /// After the kicks of a half: takes back what the other pieces will get.
    void share(BodyStore& bodies);
    /// After the contacts of a half. moves: the bodies move next.
    void keep(const BodyStore& bodies, bool moves);
    /// Moves the bodies by a sub-step of h [s], in place of how they have been moved since keep. sweep(correct): solves
    /// the joints.
    void move(BodyStore& bodies, const BodySolver& solver, double h, FunctionRef<void(bool correct)> sweep);

    std::size_t bytes() const { return bytesOf(list_) + bytesOf(before_) + bytesOf(push_) + bytesOf(places_); }

private:
    struct Place {
        SolverDisplacement displacement;
        float angle = 0;
    };

    int pieces_ = 1;
    std::vector<BodyIndex> list_;         ///< filled up with slot 0
    std::vector<SolverVelocity> before_;  ///< at the end of the last half
    std::vector<SolverVelocity> push_;    ///< of half a piece
    std::vector<Place> places_;           ///< before the move
};

}  // namespace plumb
