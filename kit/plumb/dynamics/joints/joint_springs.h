// SPDX-License-Identifier: MIT
// How stiff may springs be within a sub-step?
//
// A spring's force acts before and after each sub-step's motion, as gravity does: velocity Verlet, which keeps its
// energy. The stiffness there is k' = k F(q) / q, q = h^2 k w, F(q) = 4 sin^2(sqrt(q) / 2): so a single spring swings
// at its own frequency to rounding. Springs that share a body count each other's pull in q, and F does not grow
// beyond 1.8: no set of springs, however stiff, is past the method's limit of 4. A damper acts in both halves as well:
// first on the speed before, then on the speed after, which is of second order and stable for any damping, and exact
// for one damper alone.
// k stiffness [N/m], h sub-step [s], w what a unit of its impulse does to its rate [1/kg]
// Source: Hairer, Lubich, Wanner, "Geometric numerical integration illustrated by the Störmer-Verlet method", Acta
// Numerica 12 (2003) 399; k' makes its cosine of a sub-step's phase, 1 - h^2 k' w / 2, the true one.
// Tests: "springs of 1 to 20 Hz swing at their own frequency", "springs of any stiffness do not blow up, many on one
// body neither"
#pragma once
#include <vector>

#include <plumb/dynamics/joints/joint_store.h>
#include <plumb/math/detail/bytes_of.h>

namespace plumb {

class JointSprings {
public:
    /// Which of these joints have springs?
    void find(const std::vector<JointIndex>& joints, const JointStore& store);
    /// At the start of a step, for sub-steps of h [s]: what share of their stiffness may they have?
    void share(JointStore& store, const BodyStore& bodies, double h);
    /// Before each sub-step, before any force: how fast do their rows go?
    void noteSpeeds(JointStore& store, const BodyStore& bodies, double h) const;

    std::size_t bytes() const { return bytesOf(joints_) + bytesOf(load_); }

private:
    std::vector<JointIndex> joints_;
    std::vector<double> load_;  ///< of each body: sum over its springs of k w [1/s^2]
};

}  // namespace plumb
