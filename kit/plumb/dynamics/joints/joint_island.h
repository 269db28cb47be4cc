// SPDX-License-Identifier: MIT
// Which joints are connected through bodies, and so are solved together?
#pragma once
#include <plumb/dynamics/joints/swept_joints.h>
#include <plumb/dynamics/joints/swept_pieces.h>

namespace plumb {

class JointBatch;

struct JointIsland {
    /// Of a body, from recent forces.
    struct Stiffness {
        double along = 0, turning = 0;  ///< [N/m, N m/rad]
        double swinging = 0;            ///< turning, also by what acts within pieces of a sub-step
        double mass = 0;                ///< with which it was solved last [kg]
    };

    std::vector<JointIndex> joints;
    std::vector<LaidJoint> laid;          ///< the joints' forms and nodes, if it is not swept
    std::vector<std::uint32_t> sprung;    ///< numbers of those with springs
    double shared = 0;                    ///< sub-step for which springs that only turn are shared [s]
    std::vector<BodyIndex> bodies;        ///< that impulses move
    std::vector<BodyIndex> held;          ///< that they do not move
    std::vector<Stiffness> stiffness;     ///< of the bodies that move
    double energy = 0, lost = 0;          ///< lately, and what joints took and may give back [J] (see island_energy.h)
    double turning = 0, mostTurning = 0;  ///< of its links at the last step, and lately [rad/s]
    bool touches = false;                 ///< something, in this step
    int pieces = 1;                       ///< in which it moves in each sub-step of this step
    std::shared_ptr<const IslandLayout> layout;
    JointBatch* batch = nullptr;  ///< in this step, if it is not swept
    std::size_t lane = 0;
    SweptJoints sweptJoints;  ///< used when swept, as what follows
    SweptPieces sweptPieces;
    std::size_t levels = 0;  ///< bodies from what holds it to the farthest one

    bool isSwept() const { return layout->isSwept; }
    BodyIndex bodyAt(std::size_t node) const {
        return node < bodies.size() ? bodies[node] : held[node - bodies.size()];
    }
    std::size_t nodeOf(BodyIndex body) const {
        return static_cast<std::size_t>(std::find(bodies.begin(), bodies.end(), body) - bodies.begin());
    }
};

}  // namespace plumb
