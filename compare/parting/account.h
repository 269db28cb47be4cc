// SPDX-License-Identifier: MIT
// Which causes make up the distance between two runs of a body?
#pragma once
#include <cstddef>
#include <vector>

#include <compare/metric/joint_state.h>
#include <compare/metric/observation.h>
#include <compare/parting/touching.h>

namespace plumb::compare {

/// Two runs of a scene, and a body that is apart in them at a tick.
struct Parted {
    const Scene& scene;
    const Observation &a, &b;
    std::size_t body;
    std::size_t tick;  ///< the first tick at which it is off the other's path; at least 1
    Vec2 offset;       ///< from the other's path to the body at that tick [m]
};

/// What changes a body's velocity in a step?
enum class Agent {
    Across,   ///< a contact, along its normal
    Along,    ///< a contact, along the surface
    Joints,   ///< the joints that hold the body
    Nothing,  ///< no contact and no joint: gravity, damping, fields
    Steps,    ///< no change of velocity: the step moves the body in addition to its velocity
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
/// are measured along the offset; the largest share comes first. Steps that add less than a thousandth of the distance
/// are left out.
std::vector<Share> sharesOf(const Parted& parted, const JointStates& joints, const Touching& touching);

/// The body's centre of mass.
Vec2 centerIn(const Parted& parted, const Observation& run, std::size_t tick);

}  // namespace plumb::compare
