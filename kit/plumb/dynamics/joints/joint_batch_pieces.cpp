// SPDX-License-Identifier: MIT
// How do the bodies of a batch move in a sub-step?
//
// Where links turn fast, in pieces: in each, joints are solved before and after the bodies move, and no forces act. For
// all others the bodies have moved at their mean velocities.
// Source, of short steps for the fast part of a motion: Tuckerman, Berne, Martyna, "Reversible multiple time scale
// molecular dynamics", J. Chem. Phys. 97 (1992) 1990.
// Test: "ropes let go from any angle gain at most 1 % of their fall in a minute, and lose at most 20 %"
#include <utility>

#include <plumb/dynamics/joints/joint_batch.h>

namespace plumb {

void JointBatch::move(BodyStore& bodies, double h, double fastest, StepObserver* observer) {
    if (pieces_ == 1)
        kernel_->move(view_, h);
    else
        moveInPieces(bodies, h, fastest, observer);
    writePlaces(bodies);
}

/// Calls change(velocity, place, the field Bent) for each coordinate of each body.
template <class Change>
void JointBatch::forEachCoordinate(Change&& change) {
    for (std::size_t n = 0; n < layout_->moved; ++n)
        for (std::size_t lane = 0; lane < width_; ++lane)
            for (int c = 0; c < 3; ++c)
                change(body(n, BodyField::Vx + c, lane), body(n, BodyField::X + c, lane),
                       body(n, BodyField::BentX + c, lane));
}

void JointBatch::moveInPieces(BodyStore& bodies, double h, double fastest, StepObserver* observer) {
    const double piece = h / pieces_;
    forEachCoordinate([](double&, double place, double& bent) { bent = place; });
    for (int i = 0; i < pieces_; ++i) {
        for (const bool correct : {true, false}) {
            activate(true, 0);
            freeAsIs();
            findSolution({piece, correct, true, fastest}, Lanes(active_), correct && i > 0 ? 1 : 0);
            note(observer, piece, true);
            if (correct) kernel_->move(view_, piece);
        }
    }
    forEachCoordinate([h](double& velocity, double place, double& bent) {
        const double mean = (place - bent) / h;
        bent = velocity - mean;
        velocity = mean;
    });
    writeVelocities(bodies);
}

void JointBatch::endPieces() {
    forEachCoordinate([](double& velocity, double, double& bent) { velocity += std::exchange(bent, 0.0); });
}

}  // namespace plumb
