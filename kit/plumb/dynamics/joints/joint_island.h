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

/// The first solution of half a sub-step, before the island's contacts are known.
struct IslandTrial {
    bool wanted = false;       ///< contacts are solved together with this island
    std::vector<Vec3> before;  ///< the bodies' velocities without the joints' impulses
    std::vector<Vec3> after;   ///< with them
};

struct JointIsland {
    /// The nodes and edges of a joint's ends in the island's solver. The nodes of the bodies come first.
    struct EndNodes {
        static constexpr std::uint32_t fixed = ~std::uint32_t{0};  ///< no body of the island
        std::array<std::uint32_t, maxEnds> node{fixed, fixed, fixed, fixed};
        std::array<std::size_t, maxEnds> edge{};
    };

    std::vector<JointIndex> joints;
    std::vector<EndNodes> endNodes;  ///< of the joints
    std::vector<BodyIndex> bodies;
    std::vector<Vec3> stiffness;     ///< of the bodies, from recent forces: along x, y, turning [N/m, N m/rad]
    bool direct = true;              ///< solved directly, all joints at once; else swept
    BlockSolver solver;              ///< used when solved directly
    IslandWork work;                 ///< used when solved directly
    IslandTrial trial;               ///< used when solved together with its contacts
    HingeSweep hinges;               ///< used when swept: its plain hinges
    std::vector<JointIndex> others;  ///< used when swept: all its other joints
};

/// The islands of all joints that act and have an awake body.
struct JointIslands {
    std::vector<JointIsland> islands;   ///< in the order of their first joints
    std::vector<JointIndex> joints;     ///< of all islands, in the order of their slots
    std::vector<JointIndex> breakable;  ///< those of the joints that can break
    JointSprings springs;
    BlockPlans plans;  ///< of the islands that are solved directly
};

/// The stores that the joint solver reads and writes.
struct JointStores {
    JointStore& joints;
    JointIslands& islands;
    BodyStore& bodies;
    const SolverSettings& settings;
    StepObserver* observer = nullptr;  ///< may be null
};

}  // namespace plumb
