// SPDX-License-Identifier: MIT
// What is a world made of?
#pragma once
#include <map>
#include <optional>
#include <vector>

#include <plumb/dynamics/bodies/free_motion.h>
#include <plumb/dynamics/contacts/bounds.h>
#include <plumb/dynamics/jointed/joint_solver.h>
#include <plumb/dynamics/ledger/account.h>
#include <plumb/dynamics/sensors/sensors.h>
#include <plumb/dynamics/state/tile_store.h>
#include <plumb/dynamics/state/world_events.h>
#include <plumb/dynamics/step_profile.h>
#include <plumb/dynamics/world_def.h>

namespace plumb {

struct WorldState {
    bool sleeping = true;
    double hitSpeed = 1;  ///< [m/s]
    SolverSettings solver;

    BodyStore bodies;  ///< with gravity and wrap
    Space space;
    std::uint32_t walls = 0;        ///< number of shapes of static and kinematic bodies, without sensors
    std::uint32_t chainPieces = 0;  ///< number of segments of chains and outlines
    ContactStore contacts;
    ContactGraph graph;
    JointStore joints;
    Owned<JointSolver> jointSolver;
    FieldStore fields;
    SensorStore sensors;
    TileStore tiles;
    Trajectories trajectories;             ///< of the last step
    std::map<BodyIndex, Mass> parkedMass;  ///< masses given to bodies that are not dynamic now

    WorldEvents events;
    StaleBounds staleBounds;
    std::optional<Account> account;  ///< if WorldDef.ledger is set
    StepProfile profile;

    ShapeId idOfShape(ProxyId proxy) const { return plumb::idOfShape(bodies, space[proxy]); }
};

}  // namespace plumb
