// SPDX-License-Identifier: MIT
// Which causes make up the distance between two runs of a body?
#pragma once
#include <cstddef>
#include <vector>

#include <compare/metric/joint_state.h>
#include <compare/metric/observation.h>
#include <compare/parting/parting.h>
#include <compare/parting/touching.h>

namespace plumb::compare {

/// Two runs of a scene, and a body that is apart in them at a tick.
struct Parted {
    const Scene& scene;
    const Observation &a, &b;
    std::size_t body;
    std::size_t tick;  ///< at least 1
    Vec2 offset;       ///< from the other's path to the body at that tick [m]
};

/// How much of the distance between the two runs comes from one agent.
struct Share {
    Agent agent{};
    std::size_t other = 0;  ///< the body that it touches; else unused
    Vec2 normal{0, 1};      ///< of the contact, at its largest step
    double length = 0;      ///< [m]
    double largest = 0;     ///< the largest length of one step [m]
    std::size_t tick = 0;   ///< the tick before that step
};

/// If a step changes the difference of the two velocities by u, it adds u times the remaining time to the distance. The
/// sum over the steps, with the moves that engines make in addition to the velocities, is exactly the distance. Lengths
/// are measured along the offset; the largest share comes first. A move in addition to the velocity counts as pushed by
/// a contact if it is along the contact's normal, and else as the step's own, without what only makes it late on its
/// path.
std::vector<Share> sharesOf(const Parted& parted, const JointStates& joints, const Touching& touching);

/// The body's centre of mass.
Vec2 centerIn(const Parted& parted, const Observation& run, std::size_t tick);

}  // namespace plumb::compare
