// SPDX-License-Identifier: MIT
// Which forces act in Box2D 3, and how does a hand pull there? Only for sources that are compiled against its headers.
#pragma once
#include <box2d/box2d.h>

#include <span>
#include <vector>

#include <compare/engine/engine.h>
#include <compare/scene/joint_geometry.h>

namespace plumb::compare {

/// A world after a step of dt [s].
struct Stepped3 {
    std::span<const b2BodyId> bodies;   ///< in the scene's order; null for one that is not there
    std::span<const b2JointId> joints;  ///< the same
    std::span<const JointGeometry> geometries;
    double dt;
    int subSteps;
};

/// Of a joint and of friction, the force of the last sub-step: Box2D 3 has no mean of them.
std::vector<Push> pushes3(const Stepped3& stepped);

/// The spring of a motor joint, which is fixed to a static body of its own.
b2JointId handJoint3(b2WorldId world, b2BodyId body, const Hand& hand);
/// Takes the joint and its static body out.
void releaseHand3(b2JointId hand);

}  // namespace plumb::compare
