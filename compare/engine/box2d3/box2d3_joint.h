// SPDX-License-Identifier: MIT
// How does a scene's joint look in Box2D 3? Only for sources that are compiled against Box2D 3's headers.
#pragma once
#include <box2d/box2d.h>

#include <span>
#include <string>

#include <compare/engine/joint_geometry.h>

namespace plumb::compare {

/// What there is when a joint is made.
struct Built3 {
    b2WorldId world;
    const Scene& scene;
    std::span<const b2BodyId> bodies;
    double subStep;  ///< [s]
};

/// Its user data is its index. Springs, which Box2D 3 wants as frequencies of an effective mass, are those of the mass
/// as the bodies stand at the start. Throws Unsupported, naming the joint, when Box2D 3 has no such thing.
b2JointId addJoint3(const Built3& built, const JointGeometry& joint, std::size_t index);

/// The joint whose user data this is.
std::size_t jointOf3(const void* userData);

}  // namespace plumb::compare
