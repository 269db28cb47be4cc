// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/swept_pieces.h>

#include <plumb/math/detail/step_list.h>

namespace plumb {

namespace {

/// All four fields alike, so that it is one vector operation; of the inverse mass, b has 0.
SolverVelocity sum(const SolverVelocity& a, const SolverVelocity& b, float share) {
    return {a.x + b.x * share, a.y + b.y * share, a.w + b.w * share, a.inverseMass + b.inverseMass * share};
}

}  // namespace

void SweptPieces::begin(std::span<const BodyIndex> list, const BodyStore& bodies, int pieces) {
    pieces_ = pieces;
    if (pieces == 1) return;
    list_.assign(list.begin(), list.end());
    while (list_.size() % batchLanes != 0) list_.push_back(noBody);
    push_.assign(list_.size(), {});
    places_.resize(list_.size());
    before_.resize(list_.size());
    keep(bodies, false);
}

void SweptPieces::share(BodyStore& bodies) {
    if (pieces_ == 1) return;
    for (std::size_t i = 0; i < list_.size(); ++i) {
        SolverVelocity& v = bodies.velocity[list_[i]];
        push_[i] = sum({}, sum(v, before_[i], -1), 1 / static_cast<float>(pieces_));
        v = sum(before_[i], push_[i], 1);
    }
}

void SweptPieces::keep(const BodyStore& bodies, bool moves) {
    if (pieces_ == 1) return;
    for (std::size_t i = 0; i < list_.size(); ++i) {
        if (moves)
            places_[i] = {bodies.displacement[list_[i]], bodies.turn[list_[i]].angle};
        else
            before_[i] = bodies.velocity[list_[i]];
    }
}

/// What contacts have changed in this half stays what velocity differs from before: it is a part of their next first
/// guess (see solver_body.h).
void SweptPieces::move(BodyStore& bodies, const BodySolver& solver, double h, FunctionRef<void(bool correct)> sweep) {
    if (pieces_ == 1) return;
    StepList<SolverVelocity> byContacts(list_.size());
    StepList<FastBody> fast(list_.size() + batchLanes);
    for (std::size_t i = 0; i < list_.size(); ++i) {
        byContacts[i] = sum(bodies.velocity[list_[i]], bodies.before[list_[i]], -1);
        bodies.displacement[list_[i]] = places_[i].displacement;
        bodies.turn[list_[i]].angle = places_[i].angle;
    }
    for (int piece = 0; piece < pieces_; ++piece) {
        if (piece > 0) {
            for (const bool correct : {false, true}) {
                for (std::size_t i = 0; i < list_.size(); ++i)
                    bodies.velocity[list_[i]] = sum(bodies.velocity[list_[i]], push_[i], 1);
                sweep(correct);
            }
        }
        solver.move(list_.data(), list_.size(), bodies.solverBodies(), static_cast<float>(h / pieces_), fast.data());
    }
    keep(bodies, false);
    for (std::size_t i = 0; i < list_.size(); ++i)
        bodies.before[list_[i]] = sum(bodies.velocity[list_[i]], byContacts[i], -1);
}

}  // namespace plumb
