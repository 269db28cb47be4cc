// SPDX-License-Identifier: MIT
// Along which path has a body moved in this step?
#pragma once
#include <cstdint>
#include <vector>

#include <plumb/collide/sweep.h>
#include <plumb/dynamics/bodies/free_motion.h>
#include <plumb/shapes/aabb.h>

namespace plumb {

/// A part of a body's path.
struct PathPiece {
    Sweep sweep;
    double start = 0, end = 1;  ///< shares of the step [-]
};

/// The paths of a step. Impacts note the path of each body that they move: it has a piece for each flight between two
/// of them. For all other bodies, the path is one straight piece from the place at the step's start to the present one.
class BodyPaths {
public:
    BodyPaths(const BodyStore& bodies, const Trajectories& trajectories, double dt)
        : bodies_(bodies), trajectories_(trajectories), dt_(dt) {}

    /// Is its path a single straight piece?
    bool isStraight(BodyIndex body) const { return !bodies_.isMovedBy(body, MovedBy::Impacts); }
    /// In the order of time.
    std::vector<PathPiece> of(BodyIndex body);
    /// The straight piece from the place at the step's start to the present one.
    Sweep chordOf(BodyIndex body) const;
    /// Contains one of the body's shapes on all of its path.
    Aabb boxOf(BodyIndex body, const Shape& shape);

private:
    double aboutTurnOf(BodyIndex body) const;
    void sortSegments();

    const BodyStore& bodies_;
    const Trajectories& trajectories_;
    double dt_;
    std::vector<std::uint32_t> sorted_;  ///< entries of trajectories_, by bodies; empty until it is needed
};

}  // namespace plumb
