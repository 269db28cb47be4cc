// SPDX-License-Identifier: MIT
// How do joints and contacts, between a body and a body that stands still, differ in two runs?
#pragma once
#include <optional>

#include <compare/metric/joint_state.h>
#include <compare/parting/account.h>

namespace plumb::compare {

/// A gap or an overlap that differs between the two runs.
struct Widest {
    std::size_t joint = 0;             ///< for a gap or a break
    std::size_t bodyA = 0, bodyB = 0;  ///< for an overlap
    double valueA = 0, valueB = 0;     ///< in each run [m]; for a break [-]
    std::size_t tick = 0;              ///< when
    double together = 0;               ///< the sum of all such differences on the way to a body that stands still [m]
};

/// A body that goes through an obstacle in one run only.
struct Crossing {
    std::size_t body = 0, obstacle = 0;
    bool inA = false;      ///< true if it goes through in the first run
    std::size_t tick = 0;  ///< the tick before the step in which its centre does
};

/// Of what touches in one of the runs when the body parts: the body, or one that joints hold to it, whose centre goes
/// through a fixed obstacle in one run, then or later, and never in the other. Empty if there is none.
std::optional<Crossing> firstPassed(const Parted& parted, const JointStates& joints, const Touching& touching);

/// Looks at the joints that hold the body, over any number of joints and contacts, and that broke in one run only.
/// Returns the one that broke first: 1 in that run, 0 in the other. Empty if there is none.
std::optional<Widest> firstBreak(const Parted& parted, const JointStates& joints, const Touching& touching);

/// Of the joints that hold the body to others, the one whose gap differs most at any tick so far. Empty if there are no
/// such joints.
std::optional<Widest> widestGap(const Parted& parted, const JointStates& joints);

/// Looks at the contacts on the shortest way from the body, over joints and contacts, to a body that does not move
/// freely. Returns the contact whose depth differs most when the body parts. Empty if there is no way.
std::optional<Widest> deepestOverlap(const Parted& parted, const JointStates& joints, const Touching& touching);

}  // namespace plumb::compare
