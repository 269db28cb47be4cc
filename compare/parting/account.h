// SPDX-License-Identifier: MIT
// What is the distance between two runs of a body made of?
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
    std::size_t tick;  ///< the first at which it is off the other's path; at least 1
    Vec2 offset;       ///< from the other's path to it, then [m]
};

/// By what a body's velocity is changed in a step.
enum class Agent {
    Across,   ///< a touch, along its normal
    Along,    ///< a touch, along the surface
    Joints,   ///< what holds it
    Nothing,  ///< gravity, damping, fields
    Steps,    ///< none: where a step puts it, beside its velocity
};

/// What one agent has put between the two runs.
struct Share {
    Agent agent{};
    std::size_t other = 0;  ///< the body that touches; else unused
    Vec2 normal{0, 1};      ///< of the touch at its largest step
    double length = 0;      ///< [m]
    double largest = 0;     ///< of one step [m]
    std::size_t tick = 0;   ///< before that step
};

/// A step that changes the difference of the two velocities by u puts u times the rest of the time between the bodies;
/// summed over the steps, with what engines move bodies by beside their velocities, this is the distance, exactly.
/// Lengths are taken along the offset; the largest share comes first. Steps that add less than a thousandth of it are
/// left out.
std::vector<Share> sharesOf(const Parted& parted, const JointStates& joints, const Touching& touching);

/// The body's centre of mass.
Vec2 centerIn(const Parted& parted, const Observation& run, std::size_t tick);

}  // namespace plumb::compare
