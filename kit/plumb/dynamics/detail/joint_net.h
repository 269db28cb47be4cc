// SPDX-License-Identifier: MIT
// How are all joints of a machine solved at once?
//
// Joints that hang together through bodies are a net. One pass finds the change of velocity u and the impulses L of
//   M u - J^T L = 0,   J u + e L = r
// M masses, J the rows, r what the rows lack, e a little give that keeps rows apart which say the same; with each row
// on the part of its curve (see joint_rows.h) on which its answer lies, found by turns. No impulse is remembered: a
// chain of a thousand links, or one that carries a thousand times its weight, is solved in one pass, as a pendulum is.
// Source: Baraff, "Linear-time dynamics using Lagrange multipliers", SIGGRAPH 1996; principal pivoting: Murty 1988.
// Tests: "a chain of 20 links holds a load of a thousand times their mass"
//
// What fills in too much, as a cloth of hinges does, is swept instead, joint by joint, with soft corrections and the
// impulses of the step before as a first guess.
#pragma once
#include <plumb/dynamics/detail/audit.h>
#include <plumb/dynamics/detail/block_solver.h>
#include <plumb/dynamics/detail/hinge_sweep.h>
#include <plumb/dynamics/detail/joint_store.h>
#include <plumb/dynamics/detail/net_work.h>

namespace plumb {

struct JointNet {
    /// What the net's solver knows a joint's end by: the nodes of bodies come first.
    struct Seats {
        static constexpr std::uint32_t fixed = ~std::uint32_t{0};  ///< nothing of the net's
        std::array<std::uint32_t, mostEnds> node{fixed, fixed, fixed, fixed};
        std::array<std::size_t, mostEnds> edge{};
    };

    std::vector<JointIndex> joints;
    std::vector<Seats> seats;  ///< of the joints
    std::vector<BodyIndex> bodies;
    std::vector<Vec3> stiffness;     ///< of the bodies, by the forces of late: along x, y, turning [N/m, N m/rad]
    bool direct = true;              ///< solved at once, else swept
    BlockSolver solver;              ///< when solved at once
    NetWork work;                    ///< likewise
    HingeSweep hinges;               ///< when swept: its plain hinges
    std::vector<JointIndex> others;  ///< and the rest
};

/// What one pass over the joints is told.
struct NetPass {
    JointPass direct;  ///< for nets that are solved at once
    JointPass swept;
    HingePass hinges;
    const HingeSolver* hingeSolver = nullptr;
    Audit* audit = nullptr;  ///< keeps account, if there is one
};

/// The nets of the joints that act and have a body awake, in the order of their first joints.
/// atOnce: those of more joints are swept.
std::vector<JointNet> findNets(const JointStore& joints, const BodyStore& bodies, int atOnce);

/// Bodies that were in a net before keep their stiffness.
void keepStiffness(const std::vector<JointNet>& before, std::vector<JointNet>& nets);

/// Changes velocities to what the joints ask for, and adds to their loads.
void solveNet(JointNet& net, JointStore& joints, BodyStore& bodies, const NetPass& pass);

/// Of a net that is solved at once: takes out what contacts have done to what the joints hold.
void holdNet(JointNet& net, JointStore& joints, BodyStore& bodies, JointPass pass, Audit* audit);

/// Gives a body of a net that is solved at once an impulse (x, y, turning), and all of the net what follows from it.
void pushNet(JointNet& net, JointStore& joints, BodyStore& bodies, BodyIndex body, const Vec3& impulse, double h);

}  // namespace plumb
