// SPDX-License-Identifier: MIT
// By how much do joints and touches, between a body and what stands still, differ in two runs?
#pragma once
#include <optional>

#include <compare/metric/joint_state.h>
#include <compare/parting/account.h>

namespace plumb::compare {

/// One thing that is wider in one run than in the other.
struct Widest {
    std::size_t joint = 0;             ///< of a gap or a break
    std::size_t bodyA = 0, bodyB = 0;  ///< of an overlap
    double valueA = 0, valueB = 0;     ///< in each run [m], of a break [-]
    std::size_t tick = 0;              ///< when
    double together = 0;               ///< what it and its like come to on the way to what stands still [m]
};

/// The joint that broke first of those that broke in one run only and that hold the body, over any number of joints and
/// touches: 1 in that run, 0 in the other. Empty when there is none.
std::optional<Widest> firstBreak(const Parted& parted, const JointStates& joints, const Touching& touching);

/// Of the joints that hold the body to others, the one whose gap differs most at any tick so far. Empty when there is
/// none.
std::optional<Widest> widestGap(const Parted& parted, const JointStates& joints);

/// Of the touches on the shortest way from the body, over joints and touches, to a body that does not move freely, the
/// one whose depth differs most when the body parts. Empty when there is no way.
std::optional<Widest> deepestOverlap(const Parted& parted, const JointStates& joints, const Touching& touching);

}  // namespace plumb::compare
