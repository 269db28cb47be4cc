// SPDX-License-Identifier: MIT
// Which joints are connected through bodies, and so are solved together?
#pragma once
#include <plumb/dynamics/bodies/step_observer.h>
#include <plumb/dynamics/joints/block_solver.h>
#include <plumb/dynamics/joints/hinge_sweep.h>
#include <plumb/dynamics/joints/island_work.h>
#include <plumb/dynamics/joints/joint_springs.h>
#include <plumb/dynamics/joints/joint_store.h>
#include <plumb/dynamics/solver_settings.h>

namespace plumb {

struct JointIsland {
    /// What the island's solver knows a joint's end by: the nodes of bodies come first.
    struct EndNodes {
        static constexpr std::uint32_t fixed = ~std::uint32_t{0};  ///< nothing of the island's
        std::array<std::uint32_t, maxEnds> node{fixed, fixed, fixed, fixed};
        std::array<std::size_t, maxEnds> edge{};
    };

    std::vector<JointIndex> joints;
    std::vector<EndNodes> endNodes;  ///< of the joints
    std::vector<BodyIndex> bodies;
    std::vector<Vec3> stiffness;     ///< of the bodies, by the forces of late: along x, y, turning [N/m, N m/rad]
    bool direct = true;              ///< solved at once, else swept
    BlockSolver solver;              ///< when solved at once
    IslandWork work;                 ///< likewise
    HingeSweep hinges;               ///< when swept: its plain hinges
    std::vector<JointIndex> others;  ///< and the rest
};

/// Of the joints that act and have a body awake.
struct JointIslands {
    std::vector<JointIsland> islands;   ///< in the order of their first joints
    std::vector<JointIndex> joints;     ///< of all of them, in the order of their slots
    std::vector<JointIndex> breakable;  ///< those of them that may break
    JointSprings springs;
};

/// What joints read and write.
struct JointStores {
    JointStore& joints;
    JointIslands& islands;
    BodyStore& bodies;
    const SolverSettings& settings;
    StepObserver* observer = nullptr;  ///< if there is one
};

}  // namespace plumb
