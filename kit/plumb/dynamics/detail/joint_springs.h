// SPDX-License-Identifier: MIT
// How do springs and dampers pull within a sub-step?
//
// A force before and after each sub-step's motion, as gravity: velocity Verlet, which keeps a spring's energy. Its
// stiffness there is k' = k F(q) / q, q = h^2 k (what a unit of its impulse does to its rate), F(q) = 4 sin^2(sqrt(q) /
// 2): so a single spring swings at its own frequency to rounding. Springs that share a body count each other's pull in
// q, and F does not grow beyond 1.8: no set of springs, however stiff, is past the method's limit of 4. Damping takes
// the part 1 - exp(-c w h / 2) of the rate away, twice a sub-step, exactly. k stiffness [N/m], c damping [N s/m], h
// sub-step [s], w 1 / effective mass [1/kg] Source: Hairer, Lubich, Wanner, "Geometric numerical integration
// illustrated by the Störmer-Verlet method", Acta Numerica 12 (2003) 399; k' makes its cosine of a sub-step's phase, 1
// - h^2 k' w / 2, the true one. Test: "a spring without damping keeps its energy to 1e-3 for 20 s", "springs of any
// stiffness do not blow up"
#pragma once
#include <vector>

#include <plumb/dynamics/detail/joint_store.h>

namespace plumb {

class JointSprings {
public:
    /// Which of these joints have springs?
    void find(const std::vector<JointIndex>& joints, const JointStore& store);
    /// At the start of a step: how do they load their bodies?
    void prepare(const JointStore& store, const BodyStore& bodies);
    /// Half a sub-step of their forces; damping comes first in the half before the motion, last in the one after it.
    void pull(JointStore& store, BodyStore& bodies, double step, bool dampFirst);
    bool empty() const { return joints_.empty(); }

private:
    std::vector<JointIndex> joints_;
    std::vector<double> load_;  ///< of each body: sum over its springs of k w [1/s^2]
};

}  // namespace plumb
